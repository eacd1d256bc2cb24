"""Sheets, and the volume of meshes."""

import json
import re
import unittest

import lineatlas
from support import CUBE_POSITIONS, CUBE_TRIANGLES, FolderTest, run_tool

BOX = CUBE_POSITIONS * (20, 30, 50)
SIDES = CUBE_TRIANGLES


class Sheets(FolderTest):
    def test_is_what_the_tool_draws(self) -> None:
        scene = lineatlas.scene("clevis")
        for extension in ("svg", "dxf"):
            path = self.folder / f"tool.{extension}"
            run_tool("draw", "--scene", "clevis", "--views", "front,left,isometric",
                     "--projection", "first", "--page", "a2", "--unit", "m", "--field",
                     "title=Clevis", "--field", "file=", "-o", path)
            ours = lineatlas.to_sheet(scene.mesh, type=extension, views="front,left,isometric",
                                      angle="first", page="a2", unit=1000,
                                      fields={"title": "Clevis"})
            theirs = path.read_text()
            if extension == "dxf":
                theirs = theirs[theirs.index("  0\nSECTION"):]  # without the comments at the start
            else:
                theirs = re.sub("<desc>draw .*?</desc>", "<desc></desc>", theirs)
            self.assertEqual(ours.replace("<desc />", "<desc></desc>"), theirs)

    def test_measures_a_box(self) -> None:
        mesh = lineatlas.Mesh(BOX, SIDES)
        with lineatlas.Renderer(mesh) as renderer:
            svg = renderer.to_sheet(measures=True, scale="1:1")
            for text in (">20<", ">30<", ">50<", ">1:1<"):
                self.assertIn(text, svg)
            self.assertNotIn(">20<", renderer.to_sheet())
            pixels = renderer.to_sheet(type="picture", dpi=50.8, page="a4")
            self.assertEqual(pixels.shape, (594, 420, 4))
            self.assertTrue((pixels[..., 3] == 255).all())
            clear = renderer.to_sheet(type="picture", dpi=50.8, page="a4", transparent=True)
            self.assertEqual(clear[0, 0, 3], 0)
            self.assertTrue(renderer.to_sheet(type="pdf").startswith(b"%PDF-"))

    def test_sections(self) -> None:
        mesh = lineatlas.Mesh(BOX, SIDES)
        with lineatlas.Renderer(mesh) as renderer:
            svg = renderer.to_sheet(views="front,section:x=50%", scale="1:1")
            for text in (">A<", ">A-A<", 'id="section_A-hatching"'):
                self.assertIn(text, svg)
            svg = renderer.to_sheet(views="front", details=["front/20,30,0/4/5:1"], scale="1:1")
            self.assertIn(">A (5:1)<", svg)
            path = self.folder / "sheet.toml"
            path.write_text('[[views]]\nview = "front"\nat = [100, 100]\nscale = "1:2"\n'
                            '[[views]]\nview = "top"\n')
            self.assertIn(">(1:2)<", renderer.to_sheet(views=str(path), scale="1:1"))
            path.write_text("colour = 1\n")
            with self.assertRaisesRegex(lineatlas.FileError, "line 1: colour"):
                renderer.to_sheet(views=str(path))
            renderer.set_positions(BOX * 2)
            with self.assertRaisesRegex(lineatlas.UsageError, "the model was changed"):
                renderer.to_sheet(views="front,section:x=50%")

    def test_fills(self) -> None:
        mesh = lineatlas.Mesh(BOX, SIDES)
        style = lineatlas.Style("technical", fill="flat", fill_color="#ff8000")
        with lineatlas.Renderer(mesh) as renderer:
            sheet = renderer.to_sheet(style=style, views="front,top")
            self.assertEqual(re.findall('id="([^"]*-fill)"', sheet), ["front-fill", "top-fill"])
            (fill,) = json.loads(renderer.to_json(style=style))["fills"]
            self.assertEqual((fill["color"], len(fill["rings"])), ("#ff8000", 1))
            self.assertEqual(len(fill["rings"][0]), 6)  # a box in perspective has six corners
            self.assertNotIn("fills", json.loads(renderer.to_json()))
            self.assertNotIn('id="fill"', renderer.to_svg(style=style, plotter=True))

    def test_says_what_is_wrong(self) -> None:
        with lineatlas.Renderer(lineatlas.Mesh(BOX, SIDES)) as renderer:
            for arguments, said in (({"views": "front,middle"}, "middle"), ({"scale": "5:1"}, "fits"),
                                    ({"type": "json"}, "picture"), ({"angle": "second"}, "third"),
                                    ({"fields": {"colour": "red"}}, "approver"),
                                    ({"page": "a99"}, "a99"), ({"unit": 0.0}, "unit")):
                with self.assertRaisesRegex(lineatlas.UsageError, said):
                    renderer.to_sheet(**arguments)
            with self.assertRaisesRegex(TypeError, "fields"):
                renderer.to_sheet(fields=["title"])

    def test_volume(self) -> None:
        self.assertAlmostEqual(lineatlas.Mesh(BOX, SIDES).volume, 30000)
        self.assertAlmostEqual(lineatlas.Mesh(BOX, SIDES[:, ::-1]).volume, -30000)
        self.assertIsNone(lineatlas.Mesh(BOX, SIDES[1:]).volume)


if __name__ == "__main__":
    unittest.main()
