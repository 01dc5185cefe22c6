# assets/maker/lizard/__init__.py: the demo lizard: skeleton, body, paint, motion, muscles.
