# assets/maker/humanoid: the bundled humanoid, made by code: skeleton, body, paint, motion, muscles.
