### polygons
