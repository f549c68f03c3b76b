"""The exceptions of abstand."""


class Error(Exception):
    """What went wrong, in one line: what was found and what was expected."""


class ParseError(Error):
    """A file is not what it should be. The text is `FILE:LINE:COLUMN: error: ...`, with a second line `hint: ...` where there is one.

    `file`, `line` and `column` say where; line and column count from 1, and 0 means that they are not known."""

    file = ""
    line = 0
    column = 0


class UsageError(Error, ValueError):
    """An argument is out of range, has the wrong shape, or is no rigid transform."""


class WriteError(Error, OSError):
    """A file could not be written whole."""


for _type in (Error, ParseError, UsageError, WriteError):
    _type.__module__ = "abstand"
