#include "report.hpp"

#include <cstring>
#include <fstream>

#include <fmt/core.h>
#include <pugixml.hpp>

#include "io/atomic_file.hpp"

namespace lineatlas::bench {
namespace {

using Json = nlohmann::ordered_json;

/// The content of a file; null if the file is missing or broken, as after a crash.
Json read_json(const std::filesystem::path& path) {
    std::ifstream input{path};
    Json json = Json::parse(input, nullptr, false);
    return json.is_discarded() ? Json(nullptr) : json;
}

/// A summary of GoogleTest's report: counts, failed tests with their first message, and skipped
/// tests with the reason. Null if the file is missing or broken, as after a crash.
Json summary_of_tests(const std::filesystem::path& path) {
    pugi::xml_document document;
    if (!document.load_file(path.c_str())) return nullptr;
    const pugi::xml_node results = document.child("testsuites");
    Json summary{{"tests", results.attribute("tests").as_int()},
                 {"failures", results.attribute("failures").as_int()},
                 {"failed", Json::array()},
                 {"skipped", Json::array()}};
    for (const pugi::xml_node suite : results.children("testsuite")) {
        for (const pugi::xml_node test : suite.children("testcase")) {
            const std::string name =
                std::string{suite.attribute("name").value()} + "." + test.attribute("name").value();
            const auto add = [&](const char* list, const pugi::xml_node& what) {
                if (what)
                    summary[list].push_back(
                        {{"name", name}, {"message", what.attribute("message").value()}});
            };
            add("failed", test.child("failure"));
            add("skipped", test.child("skipped"));
        }
    }
    return summary;
}

std::string end_of(const std::string& text) {
    constexpr std::size_t most = 12000;
    return text.size() <= most ? text : text.substr(text.size() - most);
}

} // namespace

std::string outcome(const Part& part, const ChildResult& result) {
    if (result.timed_out) return fmt::format("not done in {} s", part.limit.count());
    if (result.signal != 0) return fmt::format("crashed ({})", strsignal(result.signal));
    if (result.exit_code != 0) return fmt::format("failed with {}", result.exit_code);
    return "ok";
}

Json describe_part(const Part& part, const ChildResult& result, const std::filesystem::path& file) {
    Json json{{"name", part.name},
              {"outcome", outcome(part, result)},
              {"exit_code", result.exit_code},
              {"seconds", result.took.count()}};
    if (part.kind == PartKind::tests) json["tests"] = summary_of_tests(file);
    if (part.kind == PartKind::figures || part.kind == PartKind::kernels)
        json["figures"] = read_json(file);
    if (outcome(part, result) != "ok" || part.kind == PartKind::output)
        json["output"] = end_of(result.output);
    return json;
}

void write_report(const std::filesystem::path& path, const Json& report) {
    // The output of programs need not be UTF-8.
    const std::string text = report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

} // namespace lineatlas::bench
