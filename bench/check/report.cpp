#include "report.hpp"

#include <cstring>
#include <fstream>

#include <fmt/core.h>

#include "io/atomic_file.hpp"

namespace lineatlas::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Null if the file is missing or broken, as after a crash.
Json read_json(const std::filesystem::path& path) {
    std::ifstream input{path};
    Json json = Json::parse(input, nullptr, false);
    return json.is_discarded() ? Json(nullptr) : json;
}

/// Google Test writes pages about tests that passed: counts, and what failed or was skipped.
Json summary_of_tests(const Json& results) {
    if (!results.is_object()) return nullptr;
    Json summary{{"tests", results.value("tests", 0)},
                 {"failures", results.value("failures", 0)},
                 {"failed", Json::array()},
                 {"skipped", Json::array()}};
    for (const Json& suite : results.value("testsuites", Json::array())) {
        for (const Json& test : suite.value("testsuite", Json::array())) {
            const std::string name = suite.value("name", "") + "." + test.value("name", "");
            if (test.contains("failures")) summary["failed"].push_back(name);
            if (test.value("result", "") == "SKIPPED") summary["skipped"].push_back(name);
        }
    }
    return summary;
}

std::string end_of(const std::string& text) {
    constexpr std::size_t most = 4000;
    return text.size() <= most ? text : text.substr(text.size() - most);
}

} // namespace

std::string outcome(const Part& part, const ChildResult& result) {
    if (result.timed_out) return fmt::format("not done in {} s", part.limit.count());
    if (result.signal != 0) return fmt::format("crashed ({})", strsignal(result.signal));
    if (result.exit_code != 0) return fmt::format("failed with {}", result.exit_code);
    return "ok";
}

Json describe_part(const Part& part, const ChildResult& result,
                   const std::filesystem::path& json_file) {
    Json json{{"name", part.name},
              {"outcome", outcome(part, result)},
              {"exit_code", result.exit_code},
              {"seconds", result.took.count()}};
    const Json written = read_json(json_file);
    if (part.kind == PartKind::tests) json["tests"] = summary_of_tests(written);
    if (part.kind == PartKind::figures) json["figures"] = written;
    if (outcome(part, result) != "ok") json["output"] = end_of(result.output);
    return json;
}

void write_report(const std::filesystem::path& path, const Json& report) {
    // Output of programs may hold anything.
    const std::string text = report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

} // namespace lineatlas::bench
