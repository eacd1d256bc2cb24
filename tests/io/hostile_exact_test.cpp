// Hostile STEP, IGES and BREP files: cut off, of wrong types, referring to themselves, with huge
// counts, without numbers, or nested a million deep. Each is refused in one line, or read if the
// damage does not matter (see Brep::is_read()).
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brep_fixture.hpp"

namespace lineatlas::test {
namespace {

enum class Fate { refused, either };

/// A change of a sound file: every `what` is replaced by `by`.
struct Hurt {
    std::string what, by;
    Fate fate = Fate::refused;
};

std::string sound(const std::string& name) {
    std::ifstream file(fs::path(LINEATLAS_SOURCE_DIR) / "tests/fuzz/inputs" / name,
                       std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; ++i) all += text;
    return all;
}

class HostileExact : public Brep {
  protected:
    void suffer(const std::string& folder, const std::string& file,
                const std::vector<Hurt>& hurts) {
        const std::string whole = sound(folder + '/' + file);
        ASSERT_TRUE(is_read(file, whole));
        EXPECT_GE(hurts.size() + 4, 10U);
        EXPECT_FALSE(is_read(file, whole.substr(0, whole.size() / 2)));
        EXPECT_FALSE(is_read(file, std::string(10'000, '\0')));
        EXPECT_FALSE(is_read(file, repeated("(", 1'000'000)));
        EXPECT_FALSE(is_read(file, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        for (const Hurt& hurt : hurts) {
            std::string text = whole;
            const std::size_t at = text.find(hurt.what);
            ASSERT_NE(at, text.npos) << hurt.what;
            const bool read = is_read(file, text.replace(at, hurt.what.size(), hurt.by));
            if (hurt.fate == Fate::either) continue;
            EXPECT_FALSE(read) << hurt.what << " " << hurt.by.substr(0, 99);
        }
    }
};

TEST_F(HostileExact, Step) {
    const std::string circle = "CIRCLE('',#44,1.)", shell = "CLOSED_SHELL('',(#35,#123,#127))";
    std::string offsets;
    for (int i = 1000; i < 30'000; ++i)
        offsets.append("#")
            .append(std::to_string(i))
            .append(" = OFFSET_CURVE_3D('',#")
            .append(std::to_string(i + 1))
            .append(",1.,.F.,#46);\n");
    suffer("step", "pin.step",
           {// what refers to itself
            {"MANIFOLD_SOLID_BREP('',#34)", "MANIFOLD_SOLID_BREP('',#33)"},
            {shell, "CLOSED_SHELL('',(#34,#34,#34))"},
            {circle, "CIRCLE('',#43,1.)"},
            {"SHAPE_REPRESENTATION('',(#11,#15),#19)", "SHAPE_REPRESENTATION('',(#10,#11,#15),#10)",
             Fate::either},
            {"PRODUCT_DEFINITION_FORMATION('','',#7)", "PRODUCT_DEFINITION_FORMATION('','',#6)",
             Fate::either},
            // wrong types
            {shell, "CLOSED_SHELL('',(#11,#12,#13))"},
            {shell, "CLOSED_SHELL('',7)"},
            {circle, "CIRCLE('',#44,'one')"},
            // numbers
            {circle, "CIRCLE('',#44,NAN)"},
            {circle, "CIRCLE('',#44,-1.)"},
            {circle, "CIRCLE('',#44,1.E400)", Fate::either},
            {circle, "B_SPLINE_CURVE_WITH_KNOTS('',2000000000,(#45,#45),.UNSPECIFIED.,.F.,.F.,"
                     "(2000000000,2000000000),(0.,1.),.UNSPECIFIED.)"},
            // depth
            {shell, "CLOSED_SHELL('',(" + repeated("(", 1'000'000) + "#35" +
                        repeated(")", 1'000'000) + "))"},
            {"#43 = " + circle + ";\n",
             "#43 = OFFSET_CURVE_3D('',#1000,1.,.F.,#46);\n" + offsets +
                 "#30000 = CIRCLE('',#44,1.);\n",
             Fate::either}});
}

TEST_F(HostileExact, BrepOfCounts) {
    std::vector<Hurt> hurts;
    for (const char* table : {"Curve2ds 6", "Curves 3", "Surfaces 3", "TShapes 13", "Locations 0"})
        for (const char* count : {"2000000000", "99999999999999999999", "nan"}) {
            const std::string what = table;
            hurts.push_back({what, what.substr(0, what.find(' ') + 1) + count});
        }
    suffer("brep", "pin.brep", hurts);
}

TEST_F(HostileExact, BrepOfReferencesAndNumbers) {
    suffer("brep", "pin.brep",
           {// what refers to itself, to what comes later, to nothing
            {"+13 0 -13 0 *", "+12 0 -12 0 *", Fate::either},
            {"+2 0 *", "+1 0 *", Fate::either},
            {"+7 0 +5 0 -3 0 *", "+2 0 +2 0 *", Fate::either},
            {"+2 0 *", "+999999999 0 *", Fate::either},
            {"+8 0 *", "-8 7 *", Fate::either},
            // numbers
            {"1 -2.44929359829471e-16 2", "nan nan nan", Fate::either},
            {"1 -2.44929359829471e-16 2", "1e400 inf 2", Fate::either},
            {"1 0 0 2 0 0 1 1", "9 0 0 2 0 0 1 1"},
            {"2 0 0 2 0 0 1 1", "77 0 0 2 0 0 1 1"},
            // an endless array
            {"Surfaces 3\n", "Surfaces 3\n9 1 1 1 1 2000000000 2000000000 2000000000 2 "}});
}

TEST_F(HostileExact, Iges) {
    suffer("iges", "solid.iges",
           {{"S0000001", "S9999999", Fate::either},
            {"G0000001", "D0000001", Fate::either},
            {"308,15,308,15", "99999999999999999999,15,308,15", Fate::either},
            {"2HMM", "2HXX", Fate::either},
            // references to themselves, or beyond the end
            {"186,5,1,0", "186,3,1,0", Fate::either},
            {"514,3,7,1,39", "514,3,5,1,5", Fate::either},
            {"514,3,", "514,2000000000,", Fate::either},
            {"192,11,13,1.", "192,9,13,nan", Fate::either},
            {"116,0.,0.,0.", "116,1e999,nan,-1", Fate::either},
            {"     186", "     186186", Fate::either},
            {"     514", "     186", Fate::either},
            {"     510", "     510510", Fate::either},
            {"\n", std::string(1'000'000, '1').append("\n"), Fate::either}});
}

} // namespace
} // namespace lineatlas::test
