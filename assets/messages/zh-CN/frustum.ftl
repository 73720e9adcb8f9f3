### The frustum lab: captions, watch table and controls.
