# tests/gui/x_messages.py: what other programs send to a window, by libX11: a file that is let go over it, the wish that it close.
"""Protocol of dropping: https://freedesktop.org/wiki/Specifications/XDND (version 5)."""
import ctypes
import ctypes.util
import pathlib

from waiting import Failure, wait_for

ulong, atom, window = ctypes.c_ulong, ctypes.c_ulong, ctypes.c_ulong
XDND_VERSION = 5
CLIENT_MESSAGE, SELECTION_REQUEST, SELECTION_NOTIFY = 33, 30, 31
NOW = 0


def event_of(*fields):
    """An XEvent of one kind; all begin alike."""
    begin = [("type", ctypes.c_int), ("serial", ulong), ("send_event", ctypes.c_int), ("display", ctypes.c_void_p)]
    return type("Event", (ctypes.Structure,), {"_fields_": begin + list(fields)})


ClientMessage = event_of(("window", window), ("message_type", atom), ("format", ctypes.c_int), ("data", ctypes.c_long * 5))
SelectionRequest = event_of(("owner", window), ("requestor", window), ("selection", atom), ("target", atom),
                            ("property", atom), ("time", ulong))
SelectionNotify = event_of(("requestor", window), ("selection", atom), ("target", atom), ("property", atom), ("time", ulong))


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("message", ClientMessage), ("request", SelectionRequest),
                ("notify", SelectionNotify), ("pad", ctypes.c_long * 24)]


class Sender:
    """Another program, perhaps with a file in its hand."""

    def __init__(self, display, file=None):
        self.x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
        for name, result, arguments in (
                ("XOpenDisplay", ctypes.c_void_p, [ctypes.c_char_p]), ("XCloseDisplay", ctypes.c_int, [ctypes.c_void_p]),
                ("XDefaultRootWindow", window, [ctypes.c_void_p]),
                ("XCreateSimpleWindow", window, [ctypes.c_void_p, window] + [ctypes.c_int] * 5 + [ulong] * 2),
                ("XInternAtom", atom, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int]),
                ("XSetSelectionOwner", ctypes.c_int, [ctypes.c_void_p, atom, window, ulong]),
                ("XChangeProperty", ctypes.c_int,
                 [ctypes.c_void_p, window, atom, atom, ctypes.c_int, ctypes.c_int, ctypes.c_char_p, ctypes.c_int]),
                ("XSendEvent", ctypes.c_int, [ctypes.c_void_p, window, ctypes.c_int, ctypes.c_long, ctypes.c_void_p]),
                ("XPending", ctypes.c_int, [ctypes.c_void_p]), ("XFlush", ctypes.c_int, [ctypes.c_void_p]),
                ("XNextEvent", ctypes.c_int, [ctypes.c_void_p, ctypes.c_void_p])):
            function = getattr(self.x11, name)
            function.restype, function.argtypes = result, arguments
        self.display = self.x11.XOpenDisplay(display.encode())
        if not self.display:
            raise Failure("no display " + display)
        if file is None:
            return
        root = self.x11.XDefaultRootWindow(self.display)
        self.window = self.x11.XCreateSimpleWindow(self.display, root, 0, 0, 1, 1, 0, 0, 0)
        self.bytes = (pathlib.Path(file).resolve().as_uri() + "\r\n").encode()
        self.x11.XSetSelectionOwner(self.display, self.atom("XdndSelection"), self.window, NOW)

    def atom(self, name):
        return self.x11.XInternAtom(self.display, name.encode(), False)

    def send(self, target, event):
        self.x11.XSendEvent(self.display, target, False, 0, ctypes.byref(event))
        self.x11.XFlush(self.display)

    def tell(self, target, kind, *numbers):
        event = Event()
        event.message = ClientMessage(CLIENT_MESSAGE, 0, True, self.display, target, self.atom(kind), 32,
                                      (ctypes.c_long * 5)(*numbers))
        self.send(target, event)

    def answer(self, request):
        """The file's address, where the window wants to have it."""
        self.x11.XChangeProperty(self.display, request.requestor, request.property, request.target, 8, 0, self.bytes,
                                 len(self.bytes))
        event = Event()
        event.notify = SelectionNotify(SELECTION_NOTIFY, 0, True, self.display, request.requestor, request.selection,
                                       request.target, request.property, request.time)
        self.send(request.requestor, event)

    def wait_for(self, kind):
        def look():
            while self.x11.XPending(self.display):
                event = Event()
                self.x11.XNextEvent(self.display, ctypes.byref(event))
                if event.type == SELECTION_REQUEST:
                    self.answer(event.request)
                elif event.type == CLIENT_MESSAGE and event.message.message_type == self.atom(kind):
                    return True
            return False

        wait_for(kind, look)

    def close(self):
        self.x11.XCloseDisplay(self.display)


def drop_file(display, target, point, file):
    """@param target  the window's number  @param point  on the screen"""
    sender = Sender(display, file)
    try:
        sender.tell(target, "XdndEnter", sender.window, XDND_VERSION << 24, sender.atom("text/uri-list"), 0, 0)
        place = int(point[0]) << 16 | int(point[1])
        sender.tell(target, "XdndPosition", sender.window, 0, place, NOW, sender.atom("XdndActionCopy"))
        sender.wait_for("XdndStatus")
        sender.tell(target, "XdndDrop", sender.window, 0, NOW, 0, 0)
        sender.wait_for("XdndFinished")
    finally:
        sender.close()


def ask_to_close(display, target):
    """As the button of a window manager does it."""
    sender = Sender(display)
    try:
        sender.tell(target, "WM_PROTOCOLS", sender.atom("WM_DELETE_WINDOW"), NOW)
    finally:
        sender.close()
