# blender/sinew_blender/module.py: the Python module sinew, wherever it is, or one sentence why it cannot be used.
import importlib
import os
import sys


def find(folder=""):
    """(the module, "") or (None, why not). folder: where to look besides where Python looks."""
    place = os.path.abspath(folder) if folder else ""
    if place and place not in sys.path:
        sys.path.append(place)
    try:
        sinew = importlib.import_module("sinew")
        found = sinew.__version__
    except ImportError as error:
        return None, ("The Python module sinew cannot be loaded (%s): install python3-sinew, or name the module's "
                      "folder in the preferences of the add-on." % _line(error))
    except AttributeError:
        return None, "Another Python package is called sinew: %s." % getattr(sinew, "__path__", ["?"])[0]
    from . import bl_info  # Complete by now.
    own = bl_info["version"][:2]
    if tuple(map(int, found.split(".")[:2])) != own:
        return None, "The Python module sinew is %s, and this add-on is for %d.%d: install both of one version." % (found, *own)
    return sinew, ""


def _line(error):
    return " ".join(str(error).split())
