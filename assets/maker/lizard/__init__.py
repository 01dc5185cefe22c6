# assets/maker/lizard: the demo lizard: skeleton, body, paint, motion, muscles.
