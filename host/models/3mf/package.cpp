#include "package.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <zip.h>

#include "models/part_names.hpp"
#include "refusal.hpp"
#include "required_extensions.hpp"

namespace lineatlas::threemf {

namespace {

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Entry = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

Archive open_archive(std::string_view file) {
    zip_error_t error;
    zip_error_init(&error);
    const auto fail = [&] {
        const std::string cause = zip_error_strerror(&error);
        zip_error_fini(&error);
        refuse("it is no sound ZIP archive, as 3MF files are: " + cause);
    };
    zip_source_t* source = zip_source_buffer_create(file.data(), file.size(), 0, &error);
    if (source == nullptr) fail();
    zip_t* archive = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
    if (archive == nullptr) {
        zip_source_free(source);
        fail();
    }
    zip_error_fini(&error);
    return {archive, &zip_discard};
}

zip_stat_t stat_of(zip_t* archive, zip_uint64_t index) {
    zip_stat_t stat;
    constexpr zip_uint64_t needed = ZIP_STAT_NAME | ZIP_STAT_SIZE | ZIP_STAT_ENCRYPTION_METHOD;
    if (zip_stat_index(archive, index, 0, &stat) != 0 || (stat.valid & needed) != needed)
        refuse("its ZIP archive is damaged");
    return stat;
}

/// The beginning of an entry, long enough for the first tag of any usual model.
std::string head_of(zip_t* archive, zip_uint64_t index) {
    constexpr std::size_t most = 65536;
    const Entry entry{zip_fopen_index(archive, index, 0), &zip_fclose};
    if (!entry) refuse("its ZIP archive is damaged");
    std::string head(most, '\0');
    const zip_int64_t read = zip_fread(entry.get(), head.data(), head.size());
    if (read < 0) refuse("its ZIP archive is damaged");
    head.resize(static_cast<std::size_t>(read));
    return head;
}

} // namespace

void check_package(std::string_view file) {
    // Text of vertices and triangles packs to a tenth; deflate could make a thousandth of zeros.
    constexpr std::uint64_t most_parts = 100'000, least_room = 64ULL << 20U, most_share = 100;
    const Archive archive = open_archive(file);
    const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
    if (count < 0 || static_cast<std::uint64_t>(count) > most_parts)
        refuse("its ZIP archive has more than 100000 files");
    const std::uint64_t room = least_room + most_share * file.size();
    std::uint64_t left = room;
    for (zip_uint64_t i = 0; i < static_cast<zip_uint64_t>(count); ++i) {
        const zip_stat_t stat = stat_of(archive.get(), i);
        const std::string name = models::part_name(stat.name, "a file");
        if (stat.size > left)
            refuse("it would unpack to more than " + std::to_string(room >> 20U) +
                   " MiB, which no model of its size does");
        left -= stat.size;
        if (stat.encryption_method != ZIP_EM_NONE) refuse('"' + name + "\" in it is encrypted");
        if (name.ends_with(".model")) check_required_extensions(head_of(archive.get(), i));
    }
}

} // namespace lineatlas::threemf
