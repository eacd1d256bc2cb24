// A module for pictures that a hostile file has taken over: a picture's description is the port and
// the path of a Target, and its file holds what became of each attempt, by the thread that encodes
// and by one that was started when the module was loaded, then what it has inherited. With the
// description "memory" or "time" the module takes all of it, and with "crash" it crashes.

#include <csignal>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include "hostile_attempts.hpp"
#include "io/image_module.hpp"

namespace lineatlas::images {
namespace {

test::EarlyThread early_thread;

void misbehave(const std::string& how) {
    std::vector<std::unique_ptr<std::string>> taken;
    constexpr std::size_t much = std::size_t{16} << 20U;
    while (how == "memory") taken.push_back(std::make_unique<std::string>(much, 'x'));
    while (how == "time") ::pause();
    if (how == "crash") std::raise(SIGSEGV);
}

bool can_write(const std::string&) {
    return true;
}

Image decode(const std::filesystem::path&, std::string_view) {
    return {.size = {1, 1}, .channels = 1, .pixels = {0}};
}

std::vector<unsigned char> encode(const std::filesystem::path&, const Pixels&,
                                  const ImageSettings& settings) {
    misbehave(settings.description);
    test::Target target{};
    std::istringstream{settings.description} >> target.port >> target.path;
    std::ostringstream text;
    const std::vector<int> errors = early_thread.errors(target);
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const test::Attempt& attempt = test::attempts()[i];
        text << attempt.error(target) << ' ' << errors[i] << ' ' << attempt.name << '\n';
    }
    text << "descriptors";
    for (int descriptor = 3; descriptor < 1000; ++descriptor)
        if (::close(descriptor) == 0) text << ' ' << descriptor;
    text << "\nenvironment";
    for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable)
        text << ' ' << std::string{*variable}.substr(0, std::string{*variable}.find('='));
    text << '\n';
    const std::string bytes = text.str();
    return {bytes.begin(), bytes.end()};
}

} // namespace
} // namespace lineatlas::images

extern "C" const lineatlas::images::Module lineatlas_images_3{.can_write =
                                                                  lineatlas::images::can_write,
                                                              .decode = lineatlas::images::decode,
                                                              .encode = lineatlas::images::encode};
