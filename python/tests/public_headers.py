"""What the public headers declare: names of functions, types, members and values."""

import pathlib
import re

HEADERS = pathlib.Path(__file__).parents[2] / "host" / "include" / "lineatlas"
# Headers for new devices, which Python cannot add, and for the headers themselves.
NOT_FOR_PROGRAMS = {"compute_device.hpp", "export.hpp"}


def without_comments(text: str) -> str:
    text = re.sub(r"/\*.*?\*/", "", re.sub(r"//[^\n]*", "", text), flags=re.DOTALL)
    return re.sub(r"^\s*#[^\n]*", "", text, flags=re.MULTILINE)


def without(text: str, opening: str, closing: str) -> str:
    """Text without what stands in brackets of a kind, with them."""
    result, depth = [], 0
    for letter in text:
        depth += letter == opening
        if depth == 0:
            result.append(letter)
        depth -= letter == closing
    return "".join(result)


def body_at(text: str, brace: int) -> str:
    depth = 0
    for at in range(brace, len(text)):
        depth += (text[at] == "{") - (text[at] == "}")
        if depth == 0:
            return text[brace + 1:at]
    raise ValueError("a brace is not closed")


TYPE = re.compile(r"\b(struct|class|enum class)\s+(?:LINEATLAS_API\s+)?(\w+)(?:\s+final)?\s*(?::[^;{]*)?\{")


def public_part(kind: str, body: str) -> str:
    if kind == "struct":
        return re.split(r"\b(?:private|protected):", body)[0]
    parts = re.split(r"\b(public|private|protected):", body)
    return "".join(parts[i + 1] for i in range(1, len(parts), 2) if parts[i] == "public")


def members(name: str, kind: str, body: str) -> set:
    if kind == "enum class":
        return {f"{name}.{value.split('=')[0].strip()}" for value in body.split(",") if value.strip()}
    found: set = set()
    rest = public_part(kind, body)
    while inner := TYPE.search(rest):
        inside = body_at(rest, inner.end() - 1)
        found |= {f"{name}.{inner[2]}"} | members(f"{name}.{inner[2]}", inner[1], inside)
        rest = rest[:inner.start()] + rest[inner.end() + len(inside) + 1:]
    flat = without(without(rest, "{", "}").replace("<<", ""), "<", ">")
    flat = re.sub(r"\}|LINEATLAS_API|\bfriend\b[^;]*;|\busing\b[^;]*;", "", flat)
    for declaration in re.split(r";|(?<=\))\s*(?=\n)", flat):
        declaration = declaration.strip()
        short = name.split(".")[-1]
        function = re.search(r"(\w+)\s*\(", declaration)
        if function:
            if function[1] != short and "operator" not in declaration:
                found.add(f"{name}.{function[1]}()")
        elif declaration:
            for one in declaration.split(","):
                field = re.search(r"(\w+)\s*(?:=.*)?$", one.strip(), re.DOTALL)
                if field and not re.search(r"\b(static|operator)\b", declaration):
                    found.add(f"{name}.{field[1]}")
    return found


def names_of(header: pathlib.Path) -> set:
    text = without_comments(header.read_text(encoding="utf-8"))
    found = set()
    while kind := TYPE.search(text):
        body = body_at(text, kind.end() - 1)
        found |= {kind[2]} | members(kind[2], kind[1], body)
        text = text[:kind.start()] + text[kind.end() + len(body) + 1:]
    flat = without(text.replace("<<", ""), "<", ">")
    return found | {match[1] + "()" for match in re.finditer(r"LINEATLAS_API[^;(]*?(\w+)\s*\(", flat)}


def public_names() -> dict:
    """Of every header that programs use its names."""
    return {header.name: names_of(header) for header in sorted(HEADERS.glob("*.hpp"))
            if header.name not in NOT_FOR_PROGRAMS}
