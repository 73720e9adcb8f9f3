### frustum
