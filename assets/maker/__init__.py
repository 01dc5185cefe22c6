# assets/maker/__init__.py: the parts make_demo.py is made of.
