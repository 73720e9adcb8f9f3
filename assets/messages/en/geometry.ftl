### geometry
