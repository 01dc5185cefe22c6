# assets/maker/horse/__init__.py: the bundled horse, made by code: skeleton, body, paint, motion, muscles.
