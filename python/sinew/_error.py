# python/sinew/_error.py: the one exception of the module.


class Error(ValueError):
    """What was refused: an input that cannot be used, or a value that was passed.

    file: the file it is about, as it was named, or "".
    place: where in it, or which argument: a JSON path, a joint, "bones[3] (spine)". May be "".
    reason: what is wrong and what was expected.

    str() of it is one line: file: place: reason.
    """

    def __init__(self, reason, place="", file=""):
        super().__init__(reason, place, file)
        self.file = file
        self.place = place
        self.reason = reason

    def __str__(self):
        line = ": ".join(part for part in (self.file, self.place, self.reason) if part)
        return "".join(" " if ord(letter) < 0x20 or letter == "\x7f" else letter for letter in line)
