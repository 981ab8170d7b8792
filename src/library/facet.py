"""Pictures of glTF models: facet's library in notebooks and scripts.

    import facet
    pixels = facet.render("helmet.glb", env="studio.hdr", size=(640, 480))
    radiance = facet.render("helmet.glb", radiance=True, samples=64)

Arrays are of height x width x 4, the top row first: bytes as one sees them (sRGB, straight alpha), or floats of
scene-linear radiance (associated alpha). They are NumPy's where that is installed, else memoryviews of that shape.
Options are those of `facet render`, with _ for -: tuples and lists are their numbers, True switches one on. What is
wrong raises facet.Error; what is shown otherwise than asked for is a Python warning.
"""

import ctypes
import os
import pathlib
import warnings

try:
    import numpy
except ImportError:
    numpy = None

__all__ = ["Error", "Renderer", "options", "render", "version"]

_NAME = "libfacet.so.0"
_TYPES = {False: ("B", 0), True: ("f", 1)}  # by radiance: of a sample, of the format


class Error(RuntimeError):
    """What went wrong, in one sentence. status: 2 bad input, 3 no usable OpenGL."""

    def __init__(self, message, status):
        super().__init__(message)
        self.status = status


class _Picture(ctypes.Structure):
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("format", ctypes.c_int),
                ("bytes", ctypes.c_size_t), ("pixels", ctypes.c_void_p)]


def _load():
    named = os.environ.get("FACET_LIBRARY")  # else the one that was installed with this file, else the system's
    above = pathlib.Path(__file__).resolve().parents  # .../lib/python3/dist-packages
    prefix = above[min(3, len(above) - 1)]
    beside = [*prefix.glob("lib*/" + _NAME), *prefix.glob("lib*/*/" + _NAME)]
    library = ctypes.CDLL(named or (str(beside[0]) if beside else _NAME))
    text, whole, pointer = ctypes.c_char_p, ctypes.c_int, ctypes.c_void_p
    for name, result, arguments in [
            ("version", text, []),
            ("open", whole, [ctypes.c_uint, ctypes.POINTER(pointer)]),
            ("close", None, [pointer]),
            ("load", whole, [pointer, text]),
            ("set", whole, [pointer, text, text]),
            ("render", whole, [pointer, whole, ctypes.POINTER(_Picture)]),
            ("message", text, [pointer]),
            ("warning", text, [pointer, ctypes.c_size_t]),
            ("command", text, [pointer]),
            ("option_name", text, [ctypes.c_size_t]),
            ("option_help", text, [ctypes.c_size_t])]:
        function = getattr(library, "facet_" + name)
        function.restype, function.argtypes = result, arguments
    return library


_library = _load()


def version():
    return _library.facet_version().decode()


def options():
    """Names of all options with their help."""
    found, index = {}, 0
    while name := _library.facet_option_name(index):
        found[name.decode()] = _library.facet_option_help(index).decode()
        index += 1
    return found


def _text(option, value):
    if value is None:
        return None
    if isinstance(value, bool):
        return b"true" if value else b"false"
    if isinstance(value, (tuple, list)):
        return ("x" if option == "size" else ",").join(str(part) for part in value).encode()
    return os.fsencode(value) if isinstance(value, os.PathLike) else str(value).encode("utf-8", "surrogateescape")


class Renderer:
    """Keeps what it has read for the next picture. Closes itself at the end of a with block."""

    def __init__(self, cache=True):
        self._renderer = ctypes.c_void_p()
        try:
            self._check(_library.facet_open(0 if cache else 1, ctypes.byref(self._renderer)))
        except Error:
            self.close()
            raise

    def _check(self, status):
        message = _library.facet_message(self._renderer).decode("utf-8", "replace")
        if status:
            raise Error(message, status)
        index = 0
        while text := _library.facet_warning(self._renderer, index):
            warnings.warn(text.decode("utf-8", "replace"), stacklevel=3)
            index += 1

    def _open(self):
        if not self._renderer:
            raise Error("the renderer is closed.", 2)

    def load(self, model):
        self._open()
        self._check(_library.facet_load(self._renderer, _text("model", model)))

    def set(self, **options):
        """None: as if the option had not been given."""
        self._open()
        for name, value in options.items():
            option = name.replace("_", "-")
            self._check(_library.facet_set(self._renderer, option.encode(), _text(option, value)))

    def render(self, radiance=False):
        self._open()
        picture = _Picture()
        kind, number = _TYPES[bool(radiance)]
        self._check(_library.facet_render(self._renderer, number, ctypes.byref(picture)))
        samples = memoryview(ctypes.string_at(picture.pixels, picture.bytes))
        shaped = samples.cast(kind, (picture.height, picture.width, 4))
        return numpy.array(shaped) if numpy else shaped

    @property
    def command(self):
        """The line for a shell that makes the last picture."""
        self._open()
        return _library.facet_command(self._renderer).decode("utf-8", "replace")

    def close(self):
        _library.facet_close(self._renderer)
        self._renderer = ctypes.c_void_p()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        if getattr(self, "_renderer", None):
            self.close()


def render(model, *, radiance=False, cache=True, **options):
    """One picture. Several of one model, or under one light: faster by one Renderer."""
    with Renderer(cache) as renderer:
        renderer.set(**options)
        renderer.load(model)
        return renderer.render(radiance)
