// The layout of the JSON, which other programs read.

#include "report.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lineatlas::bench {
namespace {

MethodReport method(const std::string& name) {
    MethodReport report{name, {}, {}};
    report.errors.all = {.samples = 200, .error_sum = 5, .false_visible = 4, .false_hidden = 2};
    report.motion.all = {.points = 50, .sparkle_sum = 1, .stroke_points = 10, .crawl_sum = 3};
    return report;
}

nlohmann::json parsed(const Report& report) {
    return nlohmann::json::parse(json_text(report));
}

TEST(QualityJson, HasEverySceneMethodAndFigure) {
    Report report;
    for (const char* scene : {"clevis", "a \"part\".stl"}) {
        report.subjects.push_back({scene, 12, 18, 6, 0.5, {method("IBlo"), method("SAhi")}});
    }
    const nlohmann::json json = parsed(report);
    ASSERT_EQ(json["scenes"].size(), 2U);
    for (const auto& scene : json["scenes"]) {
        ASSERT_EQ(scene["methods"].size(), 2U);
        for (const auto& figures : scene["methods"]) {
            EXPECT_DOUBLE_EQ(figures["mean_error"], 0.025);
            EXPECT_DOUBLE_EQ(figures["wrong"], 0.03);
            EXPECT_DOUBLE_EQ(figures["false_visible"], 0.02);
            EXPECT_DOUBLE_EQ(figures["false_hidden"], 0.01);
            EXPECT_DOUBLE_EQ(figures["sparkle"], 0.02);
            EXPECT_DOUBLE_EQ(figures["crawl"], 0.3);
        }
    }
    EXPECT_EQ(json["total"]["methods"]["SAhi"]["samples"], 400);
    EXPECT_DOUBLE_EQ(json["total"]["methods"]["SAhi"]["wrong"], 0.03);
}

TEST(QualityJson, WhatWasNotMeasuredIsNull) {
    Report report;
    MethodReport still = method("SAhi");
    still.motion = {};
    report.subjects.push_back({"clevis", 12, 18, 6, 0, {still}});
    const nlohmann::json figures = parsed(report)["scenes"]["clevis"]["methods"]["SAhi"];
    EXPECT_TRUE(figures.at("sparkle").is_null());
    EXPECT_TRUE(figures.at("crawl").is_null());
}

TEST(QualityJson, StudyHasAnEntryPerSetting) {
    Report report;
    report.study.push_back({"ship", {{4, 2, {.samples = 10, .error_sum = 1}, {}}}});
    const nlohmann::json point = parsed(report)["study"]["ship"][0];
    EXPECT_EQ(point["probes"], 4);
    EXPECT_EQ(point["depth_scale"], 2);
    EXPECT_DOUBLE_EQ(point["mean_error"], 0.1);
}

} // namespace
} // namespace lineatlas::bench
