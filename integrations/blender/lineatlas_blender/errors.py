"""What ends in one line for the user."""


class DrawingError(Exception):
    """Lines can't be drawn; the message says why and what to do."""
