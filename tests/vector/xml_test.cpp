#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "vector/xml.hpp"

namespace lineatlas {
namespace {

TEST(Xml, IndentsElementsAndClosesThem) {
    XmlElement root{"svg"};
    root.set("width", "10mm");
    XmlElement& group = root.add("g");
    root.add("empty");
    XmlElement& path = group.add("path");
    path.set("d", "M1 2L3 4");
    path.set("fill", "none");
    path.add("desc").set_text("a line");
    group.add("desc").set_text("");
    EXPECT_EQ(xml_document(root), "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                  "<svg width=\"10mm\">\n"
                                  " <g>\n"
                                  "  <path d=\"M1 2L3 4\" fill=\"none\">\n"
                                  "   <desc>a line</desc>\n"
                                  "  </path>\n"
                                  "  <desc></desc>\n"
                                  " </g>\n"
                                  " <empty />\n"
                                  "</svg>\n");
}

TEST(Xml, ReadersFindTextsAndValuesAgain) {
    const std::string text = "\"a\" < 'b' & c > d &amp; é";
    const std::string value = text + "\ttab\nnext";
    XmlElement root{"svg"};
    root.set("value", value);
    root.add("desc").set_text(text);
    pugi::xml_document read;
    ASSERT_TRUE(read.load_string(xml_document(root).c_str()));
    EXPECT_EQ(read.child("svg").attribute("value").value(), value);
    EXPECT_EQ(read.child("svg").child("desc").text().get(), text);
}

} // namespace
} // namespace lineatlas
