#include "program_cache_damage.hpp"

#include <fstream>
#include <iterator>

namespace lineatlas::test {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

void write(const fs::path& file, const std::string& content) {
    std::ofstream{file, std::ios::binary} << content;
}

std::string garbage(std::minstd_rand& random) {
    std::string result(1 + random() % 5000, '\0');
    for (char& c : result) c = static_cast<char>(random() >> 8U);
    return result;
}

} // namespace

std::string damage(const fs::path& file, const fs::path& other, std::minstd_rand& random) {
    std::string content = read(file);
    const auto anywhere = [&] { return random() % content.size(); };
    switch (random() % 6) {
    case 0: {
        const std::size_t place = anywhere();
        const auto bit = static_cast<unsigned char>(1U << (random() % 8));
        content[place] = static_cast<char>(static_cast<unsigned char>(content[place]) ^ bit);
        write(file, content);
        return "a bit flipped at " + std::to_string(place);
    }
    case 1: {
        const std::size_t place = anywhere();
        write(file, content.substr(0, place));
        return "cut at " + std::to_string(place);
    }
    case 2:
        write(file, "");
        return "emptied";
    case 3:
        write(file, content + garbage(random));
        return "garbage appended";
    case 4:
        write(file, garbage(random));
        return "garbage in its place";
    default:
        write(file, read(other));
        write(other, content);
        return "swapped with another";
    }
}

} // namespace lineatlas::test
