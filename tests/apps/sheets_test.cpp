// Drawings that measure, in every type of file: what a millimetre of the model is on paper, and
// what other programs read.
#include <cmath>
#include <numbers>
#include <regex>

#include "ink.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

/// Debian's own Python, which has what Debian packages for it.
const std::string python = "/usr/bin/python3 ";

bool has_ezdxf() {
    return std::system((python + "-c 'import ezdxf' 2>/dev/null").c_str()) == 0;
}

class Sheets : public Tool {
  protected:
    void SetUp() override {
        Tool::SetUp();
        write("cube.obj", prism(4, 100, 50 * std::numbers::sqrt2, 45));
        write("cylinder.obj", prism(64, 40, 50, 0));
    }

    /// Around the z axis.
    static std::string prism(int sides, double height, double radius, double turned) {
        std::string text, bottom, top;
        for (const double z : {0.0, height}) {
            for (int i = 0; i < sides; ++i) {
                const double angle = (turned + 360.0 * i / sides) * std::numbers::pi / 180;
                text += "v " + std::to_string(radius * std::cos(angle)) + " " +
                        std::to_string(radius * std::sin(angle)) + " " + std::to_string(z) + "\n";
            }
        }
        for (int i = 0; i < sides; ++i) {
            const int j = (i + 1) % sides;
            text += "f";
            for (const int corner : {i, j, sides + j, sides + i})
                text.append(" ").append(std::to_string(corner + 1));
            text += "\n";
            bottom.append(" ").append(std::to_string(sides - i));
            top.append(" ").append(std::to_string(sides + i + 1));
        }
        return text + "f" + bottom + "\nf" + top + "\n";
    }

    std::string drawn(const std::string& model, const std::string& name,
                      const std::string& options) {
        const Result result = run("draw " + path(model) + " -o " + path(name) +
                                  " --up y --view front --compute cpp --page a4 " + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        return read(path(name));
    }

    static std::vector<double> numbers(const std::string& text) {
        std::vector<double> found;
        const std::regex number{"-?[0-9]*\\.?[0-9]+"};
        for (std::sregex_iterator at{text.begin(), text.end(), number};
             at != std::sregex_iterator{}; ++at)
            found.push_back(std::stod(at->str()));
        return found;
    }

    /// Lengths of the lines of a PDF of ours, in points.
    std::vector<double> lines_of_pdf(const std::string& name) const {
        write("inflate.py", "import re, sys, zlib\n"
                            "data = open(sys.argv[1], 'rb').read()\n"
                            "for part in re.findall(rb'stream\\r?\\n(.*?)\\r?\\nendstream', data, "
                            "re.S):\n"
                            "    try: print(zlib.decompress(part).decode('latin-1'))\n"
                            "    except zlib.error: pass\n");
        const std::string text = shell(python + path("inflate.py") + " " + path(name)).output;
        std::vector<double> found;
        const std::regex line{"(-?[0-9.]+) (-?[0-9.]+) m (-?[0-9.]+) (-?[0-9.]+) l"};
        for (std::sregex_iterator at{text.begin(), text.end(), line}; at != std::sregex_iterator{};
             ++at) {
            const auto number = [&](std::size_t i) { return std::stod((*at)[i]); };
            found.push_back(std::hypot(number(3) - number(1), number(4) - number(2)));
        }
        return found;
    }

    /// What ezdxf finds wrong with files, and their lines: type, layer, length or radius.
    Result read_by_ezdxf(const std::string& name) const {
        write("read.py", "import sys, ezdxf\n"
                         "drawing = ezdxf.readfile(sys.argv[1])\n"
                         "audit = drawing.audit()\n"
                         "for wrong in audit.errors + audit.fixes: print('wrong:', wrong.message)\n"
                         "print('units', drawing.units, 'size', *drawing.header['$LIMMAX'])\n"
                         "for line in drawing.modelspace():\n"
                         "    kind = line.dxftype()\n"
                         "    if kind == 'LINE': size = (line.dxf.end - line.dxf.start).magnitude\n"
                         "    elif kind == 'LWPOLYLINE': size = len(line)\n"
                         "    elif kind == 'ELLIPSE': size = line.dxf.major_axis.magnitude\n"
                         "    else: size = line.dxf.radius\n"
                         "    print(kind, line.dxf.layer, '%.4f' % size)\n");
        return shell(python + path("read.py") + " " + path(name) + " 2>&1");
    }
};

TEST_F(Sheets, ACubeOfAHundredMillimetresAtHalfItsSize) {
    drawn("cube.obj", "a.pdf", "--scale 1:2");
    const std::vector<double> in_points = lines_of_pdf("a.pdf");
    ASSERT_EQ(in_points.size(), 4U);
    for (const double length : in_points) EXPECT_NEAR(length * 25.4 / 72, 50, 0.005);

    const std::string dxf = drawn("cube.obj", "a.dxf", "--scale 1:2");
    const std::regex line{"AcDbLine\n 10\n(.*)\n 20\n(.*)\n 30\n.*\n 11\n(.*)\n 21\n(.*)\n"};
    int lines = 0;
    for (std::sregex_iterator at{dxf.begin(), dxf.end(), line}; at != std::sregex_iterator{};
         ++at, ++lines) {
        const auto number = [&](std::size_t i) { return std::stod((*at)[i]); };
        EXPECT_NEAR(std::hypot(number(3) - number(1), number(4) - number(2)), 50, 0.001);
    }
    EXPECT_EQ(lines, 4);
}

TEST_F(Sheets, ACylinderFromItsEndIsACircle) {
    const std::string svg = drawn("cylinder.obj", "a.svg", "--scale 1:1");
    const std::size_t start = svg.find(" d=\"");
    const std::vector<double> path = numbers(svg.substr(start, svg.find('z', start) - start));
    ASSERT_EQ(path.size(), 2U + 4 * 7) << svg; // quarters
    for (std::size_t i = 2; i < path.size(); i += 7) EXPECT_NEAR(path[i], 50, 0.002);
    const std::string dxf = drawn("cylinder.obj", "a.dxf", "--scale 1:1");
    const std::size_t circle = dxf.find("AcDbCircle\n");
    ASSERT_NE(circle, std::string::npos);
    const std::size_t radius = dxf.find("\n 40\n", circle);
    EXPECT_NEAR(std::stod(dxf.substr(radius + 5)), 50, 0.002);
    // A bolt's head is a polygon, and so is what is asked to be chords.
    write("head.obj", prism(6, 40, 50, 0));
    for (const auto& [model, options] : {std::pair{"head.obj", "--scale 1:1"},
                                         std::pair{"cylinder.obj", "--scale 1:1 --curves none"}})
        EXPECT_EQ(drawn(model, "b.dxf", options).find("AcDbCircle"), std::string::npos);
    // Coarser ones are found in the drawing.
    write("coarse.obj", prism(16, 40, 50, 0));
    EXPECT_EQ(drawn("coarse.obj", "b.dxf", "--scale 1:1").find("AcDbCircle"), std::string::npos);
    EXPECT_NE(drawn("coarse.obj", "b.dxf", "--scale 1:1 --fit-arcs").find("AcDbCircle"),
              std::string::npos);
}

TEST_F(Sheets, EzdxfFindsNothingWrong) {
    if (!has_ezdxf()) GTEST_SKIP() << "python3-ezdxf is not installed";
    drawn("cube.obj", "cube.dxf", "--scale 1:2 --hidden");
    const Result cube = read_by_ezdxf("cube.dxf");
    EXPECT_EQ(cube.output, "units 4 size 297.0 210.0\nLINE outline 50.0000\nLINE outline 50.0000\n"
                           "LINE outline 50.0000\nLINE outline 50.0000\n");
    drawn("cylinder.obj", "cylinder.dxf", "--scale 1:1");
    EXPECT_NE(read_by_ezdxf("cylinder.dxf").output.find("CIRCLE outline 50.000"),
              std::string::npos);
    for (const char* options : {"", " --hidden", " --hidden --plotter --fit-arcs"}) {
        SCOPED_TRACE(options);
        for (const char* scene : {"clevis", "house"}) {
            ASSERT_EQ(run(std::string{"draw --compute cpp --scene "} + scene + options + " -o " +
                          path("a.dxf"))
                          .exit_code,
                      0);
            const Result result = read_by_ezdxf("a.dxf");
            EXPECT_EQ(result.exit_code, 0) << result.output;
            EXPECT_EQ(result.output.find("wrong"), std::string::npos) << result.output;
            EXPECT_GT(std::ranges::count(result.output, '\n'), 30);
        }
    }
}

/// A plate of 40 by 20 mm behind one of 10 by 10, seen from the front.
TEST_F(Sheets, HatchesOfFillsHaveTheAreasOfTheParts) {
    if (!has_ezdxf()) GTEST_SKIP() << "python3-ezdxf is not installed";
    write("plates.obj", "v 0 0 0\nv 40 0 0\nv 40 20 0\nv 0 20 0\n"
                        "v 5 5 1\nv 15 5 1\nv 15 15 1\nv 5 15 1\n"
                        "o plate\nf 1 2 3 4\no cover\nf 5 6 7 8\n");
    drawn("plates.obj", "a.dxf", "--scale 1:1 --fill flat --fill-color [1,0.5,0]");
    write(
        "hatches.py",
        "import sys, ezdxf\n"
        "drawing = ezdxf.readfile(sys.argv[1])\n"
        "audit = drawing.audit()\n"
        "for wrong in audit.errors + audit.fixes: print('wrong:', wrong.message)\n"
        "def area(p): return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(p, p[1:] + p[:1])) / 2\n"
        "for hatch in drawing.modelspace().query('HATCH'):\n"
        "    size = abs(sum(area(path.vertices) for path in hatch.paths))\n"
        "    print(hatch.dxf.layer, '%06x' % hatch.dxf.true_color,\n"
        "          hatch.get_xdata('LINEATLAS')[-1].value, '%.2f' % size)\n");
    const Result result = shell(python + path("hatches.py") + " " + path("a.dxf") + " 2>&1");
    EXPECT_EQ(result.output, "fill ff8000 object plate 700.00\nfill ff8000 object cover 100.00\n");
    const std::string svg =
        drawn("plates.obj", "a.svg", "--scale 1:1 --fill flat --fill-color [1,0.5,0]");
    EXPECT_NE(svg.find("<desc>object plate</desc>"), std::string::npos);
    EXPECT_NE(svg.find("fill=\"#ff8000\""), std::string::npos);
    const std::string pdf = drawn("plates.obj", "a.pdf", "");
    EXPECT_GT(drawn("plates.obj", "a.pdf", "--fill flat").size(), pdf.size());
    const std::string for_pen = drawn("plates.obj", "a.svg", "--fill flat --plotter");
    EXPECT_EQ(for_pen.find("\"fill\""), std::string::npos);
}

TEST_F(Sheets, LibreCadOpensIt) {
    if (!is_installed("librecad") || !is_installed("pdftocairo"))
        GTEST_SKIP() << "librecad or poppler-utils is not installed";
    ASSERT_EQ(run("draw --compute cpp --scene clevis --hidden --fit-arcs -o " + path("a.dxf") +
                  " --page a4 --margin 10mm")
                  .exit_code,
              0);
    // On the page that ours has: it puts what it reads in the middle of it.
    const Result result =
        shell("cd " + path("") + " && HOME=" + path("") +
              " QT_QPA_PLATFORM=offscreen librecad dxf2pdf -m -p 297x210 -c a.dxf 2>&1 && "
              "pdftocairo -png -r 96 -singlefile a.pdf theirs 2>&1");
    ASSERT_EQ(result.exit_code, 0) << result.output;
    const Ink theirs{path("theirs.png")};
    EXPECT_GT(std::ranges::count(theirs.dark, true), 5000);
}

TEST_F(Sheets, OneDrawingIsOneFile) {
    for (const std::string name : {"a.pdf", "a.dxf"}) {
        const std::string first = drawn("cube.obj", name, "");
        EXPECT_EQ(drawn("cube.obj", name, ""), first);
    }
}

TEST_F(Sheets, SeveralViewsStandOnAPage) {
    const std::string draw = "draw " + path("cube.obj") +
                             " --up y --views front,top,right,isometric "
                             "--scale 1:2 --field date=2026-01-31 --field title=Cube -o ";
    const auto sheet = [&](const std::string& name, const std::string& options = "") {
        const Result result = run(draw + path(name) + " " + options);
        EXPECT_EQ(result.exit_code, 0) << result.output;
        return read(path(name));
    };
    sheet("a.pdf");
    const std::vector<double> in_points = lines_of_pdf("a.pdf");
    const auto is_side = [](double points) { return std::abs(points * 25.4 / 72 - 50) < 0.005; };
    EXPECT_EQ(std::ranges::count_if(in_points, is_side), 3 * 4);
    for (const std::string name : {"a.svg", "a.dxf", "a.pdf", "a.png"}) {
        SCOPED_TRACE(name);
        const std::string first = sheet(name);
        EXPECT_TRUE(sheet(name) == first);
        EXPECT_TRUE(sheet(name, "--compute cpp") == first);
        EXPECT_FALSE(sheet(name, "--projection first") == first);
    }
    const std::string svg = sheet("a.svg");
    expect_refused("check " + path("a.svg") + " " + path("cube.obj"), 1, "it is a sheet");
    EXPECT_NE(svg.find("width=\"420mm\" height=\"297mm\""), std::string::npos);
    for (const char* text : {">Cube<", ">cube.obj<", ">2026-01-31<", ">1:2<", ">A3<"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    sheet("a.png");
    const Ink picture{path("a.png")};
    EXPECT_EQ(picture.size, (glm::ivec2{2480, 1754}));
}

TEST_F(Sheets, EzdxfFindsNothingWrongWithViewsOnAPage) {
    if (!has_ezdxf()) GTEST_SKIP() << "python3-ezdxf is not installed";
    const std::string draw = "draw " + path("cube.obj") + " --up y --compute cpp -o " +
                             path("a.dxf") + " --views front,30,20,back --field owner=Ω";
    ASSERT_EQ(run(draw).exit_code, 0);
    write("texts.py", "import sys, ezdxf\n"
                      "drawing = ezdxf.readfile(sys.argv[1])\n"
                      "audit = drawing.audit()\n"
                      "for wrong in audit.errors + audit.fixes: print('wrong:', wrong.message)\n"
                      "for text in drawing.modelspace().query('TEXT'): print(text.dxf.text)\n"
                      "for layer in drawing.layers: print(layer.dxf.name)\n");
    const Result found = shell(python + path("texts.py") + " " + path("a.dxf") + " 2>&1");
    EXPECT_EQ(found.exit_code, 0) << found.output;
    EXPECT_EQ(found.output.find("wrong"), std::string::npos) << found.output;
    for (const char* text : {"\nScale\n", "\n1:1\n", "\nfront-crease\n", "\nview_30_20-crease\n"})
        EXPECT_NE(found.output.find(text), std::string::npos) << text << found.output;
}

/// A plate of 60 by 40 by 10 mm with a square hole of 20 mm through its middle, along z.
TEST_F(Sheets, ASectionShowsWhatItsPlaneCuts) {
    if (!has_ezdxf()) GTEST_SKIP() << "python3-ezdxf is not installed";
    write("plate.obj", "v 0 0 0\nv 60 0 0\nv 60 40 0\nv 0 40 0\nv 0 0 10\nv 60 0 10\nv 60 40 10\n"
                       "v 0 40 10\nv 20 10 0\nv 40 10 0\nv 40 30 0\nv 20 30 0\nv 20 10 10\n"
                       "v 40 10 10\nv 40 30 10\nv 20 30 10\n"
                       "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
                       "f 9 13 14 10\nf 10 14 15 11\nf 11 15 16 12\nf 12 16 13 9\n"
                       "f 2 1 9 10\nf 3 2 10 11\nf 4 3 11 12\nf 1 4 12 9\n"
                       "f 5 6 14 13\nf 6 7 15 14\nf 7 8 16 15\nf 8 5 13 16\n");
    const auto sizes = [&](const std::string& scale, const std::string& more = "") {
        const Result made =
            run("draw " + path("plate.obj") + " --up y --compute cpp --views front,section:x=30 " +
                more + " -o " + path("a.dxf") + " --scale " + scale);
        EXPECT_EQ(made.exit_code, 0) << made.output;
        write("sizes.py",
              "import sys, ezdxf\n"
              "drawing = ezdxf.readfile(sys.argv[1])\n"
              "audit = drawing.audit()\n"
              "for wrong in audit.errors + audit.fixes: print('wrong:', wrong.message)\n"
              "for line in drawing.modelspace():\n"
              "    if 'section_A-section' != line.dxf.layer: continue\n"
              "    assert line.dxftype() == 'LWPOLYLINE' and line.closed, line\n"
              "    x, y = zip(*((p[0], p[1]) for p in line))\n"
              "    print('%.3f %.3f' % (max(x) - min(x), max(y) - min(y)))\n"
              "print(len(drawing.query('*[layer==\"section_A-hatching\"]')) > 3)\n");
        return shell(python + path("sizes.py") + " " + path("a.dxf") + " 2>&1").output;
    };
    EXPECT_EQ(sizes("1:1"), "10.000 10.000\n10.000 10.000\nTrue\n");
    EXPECT_EQ(sizes("2:1"), "20.000 20.000\n20.000 20.000\nTrue\n");
    EXPECT_EQ(sizes("1:1", "--hatching none"), "10.000 10.000\n10.000 10.000\nFalse\n");
}

/// A cylinder with a radius of 50 mm, seen along its axis. A circle about a place of its border
/// leaves twice 4 asin(r / 100) of it.
TEST_F(Sheets, ADetailKeepsArcs) {
    if (!has_ezdxf()) GTEST_SKIP() << "python3-ezdxf is not installed";
    write("arcs.py", "import sys, ezdxf\n"
                     "drawing = ezdxf.readfile(sys.argv[1])\n"
                     "audit = drawing.audit()\n"
                     "for wrong in audit.errors + audit.fixes: print('wrong:', wrong.message)\n"
                     "for arc in drawing.query('ARC'):\n"
                     "    span = (arc.dxf.end_angle - arc.dxf.start_angle) % 360\n"
                     "    print(arc.dxf.layer, '%.2f %.2f' % (arc.dxf.radius, span))\n"
                     "for circle in drawing.query('CIRCLE[layer==\"details\"]'):\n"
                     "    print('%.3f' % circle.dxf.radius)\n"
                     "for text in drawing.query('TEXT[layer==\"details\"]'):\n"
                     "    print(text.dxf.text)\n");
    const auto found = [&](const std::string& scale, const std::string& detail) {
        const Result made =
            run("draw " + path("cylinder.obj") + " --up y --compute cpp --views front --detail " +
                detail + " -o " + path("a.dxf") + " --scale " + scale);
        EXPECT_EQ(made.exit_code, 0) << made.output;
        return shell(python + path("arcs.py") + " " + path("a.dxf") + " 2>&1").output;
    };
    // 4 asin(0.2) are 46.15 degrees.
    EXPECT_EQ(found("1:1", "front/50,0,0/20"),
              "detail_A-crease 100.00 46.15\n20.000\n40.000\nA\nA (2:1)\n");
    EXPECT_EQ(found("1:2", "front/50,0,0/20/5:2"),
              "detail_A-crease 125.00 46.15\n10.000\n50.000\nA\nA (5:2)\n");
}

TEST_F(Sheets, AFilePlacesViews) {
    if (!has_ezdxf()) GTEST_SKIP() << "python3-ezdxf is not installed";
    const auto file = [&](const std::string& scale) {
        write("sheet.toml", "page = \"a2\"\nscale = \"" + scale +
                                "\"\nprojection = \"first\"\n"
                                "[fields]\ntitle = \"Cube\"\n"
                                "[[views]]\nview = \"front\"\nat = [150, 100.5]\n"
                                "[[views]]\nview = \"top\"\nat = [400, 90]\nscale = \"1:4\"\n"
                                "[[views]]\nview = \"section:z=50\"\nat = [150, 300]\n"
                                "[[details]]\nview = \"front\"\ncenter = [50, 50, 0]\nradius = 10\n"
                                "at = [350, 250]\n");
        const Result made = run("draw " + path("cube.obj") + " --up y --compute cpp --views " +
                                path("sheet.toml") + " -o " + path("a.dxf"));
        EXPECT_EQ(made.exit_code, 0) << made.output;
        write("boxes.py",
              "import sys, ezdxf\n"
              "from ezdxf import bbox\n"
              "drawing = ezdxf.readfile(sys.argv[1])\n"
              "audit = drawing.audit()\n"
              "for wrong in audit.errors + audit.fixes: print('wrong:', wrong.message)\n"
              "for layer in 'front-crease', 'top-crease', 'section_A-section':\n"
              "    box = bbox.extents(drawing.query(f'*[layer==\"{layer}\"]'))\n"
              "    print('%.3f %.3f %.3f' % (box.center.x, box.center.y, box.size.x))\n"
              "for text in drawing.query('TEXT'):\n"
              "    if '(' in text.dxf.text or text.dxf.text == 'Cube': "
              "print(text.dxf.text)\n");
        return shell(python + path("boxes.py") + " " + path("a.dxf") + " 2>&1").output;
    };
    // An A2 page is 420 mm high, and y goes up in DXF.
    EXPECT_EQ(file("1:1"), "150.000 319.500 100.000\n400.000 330.000 25.000\n"
                           "150.000 120.000 100.000\n(1:4)\nB (2:1)\nCube\n");
    EXPECT_EQ(file("1:2"), "150.000 319.500 50.000\n400.000 330.000 25.000\n"
                           "150.000 120.000 50.000\n(1:4)\nB (1:1)\nCube\n");
}

TEST_F(Sheets, AnEmptyScaleOfAFileIsNone) {
    const auto drawn_by = [&](const std::string& scale, const std::string& out) {
        write("sheet.toml", scale + "[[views]]\nview = \"front\"\n" + scale +
                                "[[details]]\nview = \"front\"\ncenter = [50, 50, 0]\n"
                                "radius = 10\n" +
                                scale);
        const Result made = run("draw " + path("cube.obj") + " --up y --compute cpp --views " +
                                path("sheet.toml") + " -o " + path(out));
        EXPECT_EQ(made.exit_code, 0) << made.output;
        return read(path(out));
    };
    EXPECT_EQ(drawn_by("scale = \"\"\n", "empty.svg"), drawn_by("", "none.svg"));
}

TEST_F(Sheets, WhatIsWrongWithASheetsFileIsSaidInALine) {
    const auto refused = [&](const std::string& text, const std::string& words) {
        write("bad.toml", text);
        expect_refused("draw " + path("cube.obj") + " --up y -o " + path("x.svg") + " --views " +
                           path("bad.toml"),
                       1, words);
    };
    refused("page = \"a3\"\nscael = \"1:1\"\n",
            "bad.toml\" line 2: scael: a sheet has no such key; did you mean \"scale\"?");
    refused("[[views]]\nview = \"front\"\nplace = [1, 2]\n",
            "line 3: place: a view has no such key");
    refused("[[views]]\nat = [1, 2]\n", "each needs a \"view\"");
    refused("[[views]]\nview = \"front\"\nat = [1]\n",
            "line 3: at: it must be a list of 2 numbers");
    refused("[[views]]\nview = \"middle\"\n", "line 2: view: there is no view \"middle\"");
    refused("page = \"a3\"\nscale = \"big\"\n",
            "bad.toml\" line 2: scale: the scale \"big\" must be two numbers");
    refused("[[details]]\nradius = -1\n", "line 2: radius: it must be a number above 0");
    refused("[[details]]\nradius = 1\nscale = \"2\"\n",
            "line 3: scale: the scale \"2\" must be two numbers");
    refused("[[details]]\nview = \"front\"\n", "each needs a \"center\"");
    refused("[fields]\ncolour = \"red\"\n", "a title block has no field \"colour\"");
    refused("page = 3\n", "line 1: page: it must be a text");
    refused("views = \"front\"\n", "[[double brackets]]");
    refused("page = \n", "line 1");
    EXPECT_FALSE(fs::exists(path("x.svg")));
}

TEST_F(Sheets, AutomaticSheetsSummariseThePart) {
    const auto summary = [&](const std::string& model, const std::string& options = "") {
        return run("draw " + path(model) + " --up y --views auto -o " + path("a.svg") + " " +
                   options);
    };
    const Result cube = summary("cube.obj");
    ASSERT_EQ(cube.exit_code, 0) << cube.output;
    for (const char* text :
         {"\"size_mm\": [\n    100.0,\n    100.0,\n    100.0\n  ]", "\"volume\": 1000000.0",
          "\"notes\": []", "\"scale\": \"1:2\"",
          "\"balloons\": [\n          {\n            \"item\": 1,", "\"name\": \"isometric\""})
        EXPECT_NE(cube.output.find(text), std::string::npos) << text << cube.output;
    const std::string svg = read(path("a.svg"));
    for (const char* text : {">100<", ">X<", ">100 mm<"})
        EXPECT_NE(svg.find(text), std::string::npos) << text;
    EXPECT_EQ(summary("cube.obj").output, cube.output);
    EXPECT_EQ(summary("cube.obj", "--compute cpp").output, cube.output);
    EXPECT_EQ(read(path("a.svg")), svg);
    write("open.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n");
    const Result open = summary("open.obj");
    EXPECT_NE(open.output.find("\"volume\": null"), std::string::npos) << open.output;
    EXPECT_NE(open.output.find("the surface is not closed"), std::string::npos) << open.output;
}

TEST_F(Sheets, WhatIsWrongWithAPageOfViewsIsSaidInALine) {
    const std::string draw = "draw " + path("cube.obj") + " --up y -o ";
    const std::string to = draw + path("x.svg") + " --views ";
    expect_refused(to + "front,middle", 2, "there is no view \"middle\"");
    expect_refused(to + "front,top,front", 2, "\"front\" is named twice");
    expect_refused(to + "front,section:z=50", 2, "no view shows its plane as a line; add top");
    expect_refused(to + "top,section:z=500", 2, "misses the model, which goes from z=0 to 100");
    expect_refused(to + "front --detail front/0,0,0", 2, "as in front/20,35,0/8");
    expect_refused(to + "front --detail front/900,0,0/5", 2, "lies beside the model");
    expect_refused(draw + path("x.svg") + " --detail front/0,0,0/5", 2,
                   "--detail needs --views; add it, or leave out --detail");
    expect_refused(to + "front --hatching none", 2,
                   "--hatching needs --section, or a section of --views; add one");
    expect_refused(to + "front --view top", 2, "--views and --view exclude each other");
    expect_refused(to + "front --margin 5mm", 2, "--views and --margin exclude each other");
    expect_refused(to + "front --scale 5:1", 2, "2:1 fits");
    expect_refused(to + "front --projection second", 2, "must be first or third");
    expect_refused(to + "front --field colour=red", 2, "title, file, owner");
    expect_refused(to + "front --field title", 2, "title=Bracket");
    expect_refused(to + "front --page 80x80mm", 2, "too small for a sheet");
    expect_refused(to + "front --method atlas", 2, "only exact");
    expect_refused(to + "front --dpi 300", 2, "--dpi is for pictures of pixels");
    expect_refused(draw + path("x.svg") + " --field title=Cube", 2,
                   "--field needs --views; add it, or leave out --field");
    expect_refused(draw + path("x.eps") + " --views front", 1, "other programs make .eps");
    expect_refused(draw + path("x.json") + " --views front", 1, "JSON has one view");
    expect_refused(draw + path("x.png") + " --views front --no-tags", 2, "is for SVG alone");
    EXPECT_FALSE(fs::exists(path("x.svg")));
}

TEST_F(Sheets, WhatIsWrongIsSaidInALine) {
    const std::string draw = "draw " + path("cube.obj") + " --view front --compute cpp ";
    for (const std::string name : {"x.dxf", "x.pdf"}) {
        SCOPED_TRACE(name);
        const std::string to = "-o " + path(name);
        expect_refused(draw + to + " --units mm", 2, "--units is for SVG");
        expect_refused(draw + to + " --no-tags", 2, "no tags");
        expect_refused(draw + to + " --page a4 --scale 5:1", 2, "2:1 fits");
        expect_refused(draw + to + " --page a6 --margin 80mm", 2, "no room");
        expect_refused(draw + "-o " + path("missing/" + name), 1, "its folder does not exist");
        expect_refused(draw + "-o /proc/" + name, 1, "/proc");
    }
    expect_refused(draw + "--fit-arcs -o " + path("x.json"), 2, "JSON is in pixels");
    expect_refused(draw + "--fit-arcs -o " + path("x.png"), 2, "is for paths");
    expect_refused(draw + "-o " + path("x.dwg"), 1, ".dxf");
    const Result none = shell("LINEATLAS_MODULE_DIR=/nowhere " LINEATLAS_TOOL " " + draw + "-o " +
                              path("x.pdf") + " 2>&1");
    EXPECT_EQ(none.exit_code, 1);
    EXPECT_NE(none.output.find("lineatlas-pdf.so\", which writes PDF"), std::string::npos)
        << none.output;
    EXPECT_FALSE(fs::exists(path("x.pdf")));
}

} // namespace
} // namespace lineatlas::test
