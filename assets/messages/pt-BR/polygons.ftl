### The polygons lab: captions, watch table and controls.
