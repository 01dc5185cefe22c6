# assets/maker/humanoid/__init__.py: the bundled humanoid, made by code: skeleton, body, paint, motion, muscles.
