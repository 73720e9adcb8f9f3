### The lines lab: captions, watch table and controls.
