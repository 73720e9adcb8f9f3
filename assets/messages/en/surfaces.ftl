### surfaces
