"""Draws a model from the command line: python3 -m lineatlas MODEL -o picture.png"""

from __future__ import annotations

import argparse
import pathlib
import sys
import typing
import warnings

import lineatlas


def _size(text: str) -> tuple[int, int]:
    width, _, height = text.partition("x")
    return int(width), int(height)


def _vector(text: str) -> tuple[float, float, float]:
    x, y, z = (float(part) for part in text.split(","))
    return x, y, z


def _up(text: str) -> str | tuple[float, float, float]:
    return _vector(text) if "," in text else text


def _crease(text: str) -> float | str:
    return text if text == "auto" else float(text)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python3 -m lineatlas",
        description="Draws the visible lines of a model. `lineatlas draw` can do more.")
    parser.add_argument("model", nargs="?", metavar="MODEL", help="file of a type that lineatlas.load() reads")
    parser.add_argument("--scene", choices=lineatlas.SCENES, help="a built-in model in its place")
    parser.add_argument("-o", "--output", required=True, type=pathlib.Path,
                        help="picture to write: .png, .jpg, .tif, ...; paths: .svg, .pdf, .dxf, .json")
    parser.add_argument("--size", type=_size, default=(1024, 768), metavar="WIDTHxHEIGHT",
                        help="in pixels; default 1024x768")
    parser.add_argument("--style", help="a name or a file: " + ", ".join(lineatlas.styles()))
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE",
                        help="a setting of the style; may be repeated")
    parser.add_argument("--lines", help="kinds of lines, separated by commas; default all")
    parser.add_argument("--crease", type=_crease, default="auto",
                        help="degrees, or auto; default auto")
    parser.add_argument("--eye", type=_vector, metavar="X,Y,Z", help="default: frames the model")
    parser.add_argument("--target", type=_vector, metavar="X,Y,Z", help="default 0,0,0")
    parser.add_argument("--up", type=_up, help="x, y, z or X,Y,Z; default y")
    parser.add_argument("--fov", type=float, default=40, help="degrees; default 40")
    parser.add_argument("--quality", default="high", help="low or high")
    parser.add_argument("--transparent", action="store_true", help="leave the paper out")
    parser.add_argument("--device", default="", help="opencl:<platform>[:<device>]")
    parser.add_argument("--compute", default="", help="opencl or cpp; opencl where there is a driver")
    return parser


def _style(arguments: argparse.Namespace) -> lineatlas.Style:
    style = lineatlas.Style(arguments.style)
    for change in arguments.set:
        key, equals, value = change.partition("=")
        if not equals:
            raise lineatlas.UsageError(f'--set "{change}" is not key=value')
        style[key] = value
    return style


def _view(arguments: argparse.Namespace, renderer: lineatlas.Renderer,
          scene: lineatlas.Scene | None) -> lineatlas.View:
    if arguments.eye is not None:
        up = {"x": (1, 0, 0), None: (0, 1, 0), "y": (0, 1, 0), "z": (0, 0, 1)}.get(arguments.up)
        return lineatlas.View(arguments.eye, arguments.target or (0, 0, 0),
                              up or arguments.up, arguments.fov)
    if arguments.target is not None:
        raise lineatlas.UsageError("--target needs an --eye")
    if scene is not None:
        return scene.view(0)
    return renderer.frame(size=arguments.size, up=arguments.up or "y", fov=arguments.fov)


def _write(arguments: argparse.Namespace) -> None:
    if (arguments.model is None) == (arguments.scene is None):
        raise lineatlas.UsageError("name either a MODEL file or a --scene")
    style = _style(arguments)
    scene = lineatlas.scene(arguments.scene) if arguments.scene else None
    mesh = scene.mesh if scene else lineatlas.load(arguments.model)
    for note in mesh.notes:
        print(f"lineatlas: {note}", file=sys.stderr)
    with lineatlas.Renderer(mesh, lines=arguments.lines, crease=arguments.crease,
                            compute=arguments.compute, device=arguments.device) as renderer:
        view = _view(arguments, renderer, scene)
        options = lineatlas.Options(quality=arguments.quality)
        extension = arguments.output.suffix.lower()
        how: dict[str, typing.Any] = {"size": arguments.size, "view": view, "style": style,
                                      "options": options}
        if extension == ".svg":
            text = renderer.to_svg(**how, transparent=arguments.transparent)
        elif extension == ".json":
            text = renderer.to_json(**how)
        elif extension == ".dxf":
            text = renderer.to_dxf(**how)
        else:
            text = ""
        if text:
            arguments.output.write_text(text, encoding="utf-8")
            return
        if extension == ".pdf":
            arguments.output.write_bytes(renderer.to_pdf(**how, transparent=arguments.transparent))
            return
        picture = renderer.draw(size=arguments.size, view=view, style=style, options=options,
                                transparent=arguments.transparent)
    lineatlas.save(arguments.output, picture)


def main(words: list[str] | None = None) -> int:
    """Runs the command line; returns its exit code: 0 done, 1 failed, 2 wrong usage."""
    arguments = _parser().parse_args(words)
    try:
        with warnings.catch_warnings(record=True) as flaws:
            warnings.simplefilter("always", UserWarning)
            _write(arguments)
        for flaw in flaws:
            print(f"lineatlas: {flaw.message}", file=sys.stderr)
    except (lineatlas.Error, OSError) as error:
        print(f"lineatlas: {error}", file=sys.stderr)
        return 2 if isinstance(error, lineatlas.UsageError) else 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
