//! One file a method: its sentences, marks and watched values.
