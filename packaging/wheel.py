"""Packs a folder as a wheel (PEP 427) for this Python: python3 wheel.py CONTENT FOLDER VERSION
CONTENT has the package, its libraries and lineatlas-VERSION.dist-info with licences."""

import base64
import hashlib
import os
import pathlib
import platform
import sys
import zipfile


def metadata(version):
    minor = sys.version_info.minor
    return f"""Metadata-Version: 2.1
Name: lineatlas
Version: {version}
Summary: Line drawings of 3D models: what is visible of their lines, as pictures and as arrays
License-File: LICENSE
Requires-Python: >=3.{minor},<3.{minor + 1}
Requires-Dist: numpy
"""


def main(content, folder, version):
    content, folder = pathlib.Path(content), pathlib.Path(folder)
    info = content / f"lineatlas-{version}.dist-info"
    (content / "lineatlas-VERSION.dist-info").rename(info)
    python = f"cp3{sys.version_info.minor}"
    # The wheel needs no newer glibc than that of the machine that builds it.
    libc = platform.libc_ver()[1].replace(".", "_")
    tag = f"{python}-{python}-manylinux_{libc}_{platform.machine()}"
    (info / "METADATA").write_text(metadata(version))
    (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: lineatlas\nRoot-Is-Purelib: false\nTag: {tag}\n")
    record = f"{info.name}/RECORD"
    rows = []
    for old in folder.glob("*.whl"):
        old.unlink()
    with zipfile.ZipFile(folder / f"lineatlas-{version}-{tag}.whl", "w", zipfile.ZIP_DEFLATED) as wheel:
        for path in sorted(path for path in content.rglob("*") if path.is_file()):
            name, data = path.relative_to(content).as_posix(), path.read_bytes()
            entry = zipfile.ZipInfo(name)  # of 1980: equal content is an equal wheel
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if os.access(path, os.X_OK) else 0o644) << 16
            wheel.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            rows.append(f"{name},sha256={digest},{len(data)}")
        wheel.writestr(zipfile.ZipInfo(record), "\n".join([*rows, f"{record},,", ""]))


main(*sys.argv[1:])
