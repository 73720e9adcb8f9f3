### The surfaces lab: captions, watch table and controls.
