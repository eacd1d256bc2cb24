#include "tuning_table.hpp"

#include <algorithm>
#include <set>

#include <toml++/toml.h>

#include "lineatlas/error.hpp"

namespace lineatlas::compute {
namespace {

constexpr std::string_view types[] = {"cpu", "gpu", "other"};

std::string_view type_of(const OpenClDevice& device) {
    return device.is_cpu ? "cpu" : device.is_gpu ? "gpu" : "other";
}

/// The names of a device that a row may match by a part.
constexpr std::string OpenClDevice::*names[] = {
    &OpenClDevice::platform_name, &OpenClDevice::device_name, &OpenClDevice::driver_version};

/// The allowed values of a field, in words.
std::string kind_of(const TuningField& field) {
    if (std::holds_alternative<bool Tuning::*>(field.member)) return "true or false";
    if (field.allowed.empty()) return "a whole number from 1 to " + std::to_string(field.most);
    std::string result = "one of";
    for (const std::uint32_t value : field.allowed) result += ' ' + std::to_string(value);
    return result;
}

bool allows(const TuningField& field, std::int64_t value) {
    if (field.allowed.empty()) return value >= 1 && value <= field.most;
    return std::ranges::find(field.allowed, value) != field.allowed.end();
}

} // namespace

std::span<const TuningField> tuning_fields() {
    constexpr std::uint32_t largest_group = 1024; // of OpenCL devices
    constexpr std::uint32_t largest_block = 1U << 20U;
    static const TuningField fields[] = {
        {"scan_tiles", &Tuning::scan_tiles},
        {"scan_chunks", &Tuning::scan_chunks, {}, largest_block},
        {"scan_tile", &Tuning::scan_tile, {16, 32, 64, 128, 256, 512, 1024}},
        {"scan_per_item", &Tuning::scan_per_item, {}, 64},
        {"local_size", &Tuning::local_size, {}, largest_group},
        {"block_local_size", &Tuning::block_local_size, {}, largest_group},
        {"atlas_block", &Tuning::atlas_block, {}, largest_block},
        {"atlas_vectors", &Tuning::atlas_vectors},
        {"depth_lanes", &Tuning::depth_lanes, {1, 4, 8}},
        {"depth_tile", &Tuning::depth_tile, {16, 32, 64, 128, 240, 256}},
        {"depth_workers", &Tuning::depth_workers, {}, largest_block},
        {"depth_clusters", &Tuning::depth_clusters, {}, ~0U},
        {"depth_each", &Tuning::depth_each},
        {"stroke_pixels", &Tuning::stroke_pixels},
        {"halo_lanes", &Tuning::halo_lanes, {1, 8, 16}},
        {"face_lanes", &Tuning::face_lanes, {1, 4, 8, 16}},
        {"face_chunks", &Tuning::face_chunks, {}, 4096},
        {"face_lists", &Tuning::face_lists},
        {"segment_block", &Tuning::segment_block, {}, largest_block},
        {"program_cache", &Tuning::program_cache},
    };
    return fields;
}

void set_value(Tuning& tuning, const TuningField& field, std::uint32_t value) {
    if (const auto* flag = std::get_if<bool Tuning::*>(&field.member))
        tuning.*(*flag) = value != 0;
    else
        tuning.*std::get<std::uint32_t Tuning::*>(field.member) = value;
}

std::string text_of(const TuningField& field, const Tuning& tuning) {
    if (const auto* flag = std::get_if<bool Tuning::*>(&field.member)) {
        return tuning.*(*flag) ? "true" : "false";
    }
    return std::to_string(tuning.*std::get<std::uint32_t Tuning::*>(field.member));
}

/// Turns a file's text into rows.
class TuningReader {
  public:
    explicit TuningReader(std::string place) : place_(std::move(place)) {}

    std::vector<TuningTable::Row> rows_of(std::string_view text) const {
        const toml::table file = parse(text);
        std::vector<TuningTable::Row> rows;
        for (const auto& [key, node] : file) {
            const toml::array* list = node.as_array();
            if (key != "row" || list == nullptr) {
                refuse(key.source(), key.str(), "is not known here; a table has only [[row]]");
            }
            for (const toml::node& row : *list) rows.push_back(row_of(row));
        }
        return rows;
    }

  private:
    [[noreturn]] void refuse(const toml::source_region& where, std::string_view field,
                             const std::string& cause) const {
        throw FileError(place_ + ", line " + std::to_string(where.begin.line) + ": \"" +
                        std::string{field} + "\" " + cause);
    }

    toml::table parse(std::string_view text) const {
        try {
            return toml::parse(text);
        } catch (const toml::parse_error& error) {
            throw FileError(place_ + ", line " + std::to_string(error.source().begin.line) + ": " +
                            std::string{error.description()});
        }
    }

    TuningTable::Row row_of(const toml::node& node) const {
        const toml::table* table = node.as_table();
        if (table == nullptr) refuse(node.source(), "row", "is not a table");
        TuningTable::Row row;
        const toml::node* match = table->get("match");
        if (match == nullptr) refuse(node.source(), "row", "has no match; match = {} fits all");
        for (const auto& [key, value] : *table) {
            if (key == "match")
                read_match(value, row);
            else
                read_value(key, value, row);
        }
        return row;
    }

    void read_match(const toml::node& node, TuningTable::Row& row) const {
        const toml::table* table = node.as_table();
        if (table == nullptr) refuse(node.source(), "match", "is not a table in braces");
        for (const auto& [key, value] : *table) {
            const auto text = value.value<std::string>();
            if (!text || text->empty()) refuse(value.source(), key.str(), "must be a text");
            if (key == "platform")
                row.parts.platform_name = *text;
            else if (key == "device")
                row.parts.device_name = *text;
            else if (key == "driver")
                row.parts.driver_version = *text;
            else if (key == "type")
                row.type = read_type(value, *text);
            else
                refuse(key.source(), key.str(),
                       "is no part of match: platform, device, driver, type");
        }
    }

    std::string read_type(const toml::node& node, const std::string& type) const {
        if (std::ranges::find(types, type) == std::end(types))
            refuse(node.source(), "type", "must be cpu, gpu or other");
        return type;
    }

    void read_value(const toml::key& key, const toml::node& node, TuningTable::Row& row) const {
        const auto field = std::ranges::find(tuning_fields(), key.str(), &TuningField::name);
        if (field == tuning_fields().end()) refuse(key.source(), key.str(), "is not known");
        const bool is_flag = std::holds_alternative<bool Tuning::*>(field->member);
        const auto flag = node.value_exact<bool>();
        const auto number = node.value_exact<std::int64_t>();
        if (is_flag ? !flag : !number || !allows(*field, *number)) {
            refuse(node.source(), key.str(), "must be " + kind_of(*field));
        }
        row.values.emplace_back(&*field, is_flag ? *flag : static_cast<std::uint32_t>(*number));
    }

    std::string place_;
};

TuningTable::TuningTable(std::string_view text, const std::string& place)
    : place_(place), rows_(TuningReader{place}.rows_of(text)) {}

bool TuningTable::Row::matches(const OpenClDevice& device) const {
    return (type.empty() || type == type_of(device)) &&
           std::ranges::all_of(names, [&](std::string OpenClDevice::*name) {
               return contains_ignoring_case(device.*name, parts.*name);
           });
}

std::vector<OpenClDevice> TuningTable::examples() const {
    std::vector<OpenClDevice> result;
    for (const Row& row : rows_) {
        for (const std::string_view type : types) {
            if (!row.type.empty() && row.type != type) continue;
            result.push_back(row.parts);
            result.back().is_cpu = type == "cpu";
            result.back().is_gpu = type == "gpu";
        }
    }
    return result;
}

Tuning TuningTable::values_for(const OpenClDevice& device) const {
    Tuning tuning;
    std::set<const TuningField*> given;
    for (const Row& row : rows_) {
        if (!row.matches(device)) continue;
        for (const auto& [field, value] : row.values) {
            set_value(tuning, *field, value);
            given.insert(field);
        }
    }
    for (const TuningField& field : tuning_fields()) {
        if (given.contains(&field)) continue;
        throw FileError(place_ + ": no row gives \"" + std::string{field.name} + "\" to " +
                        device.name());
    }
    return tuning;
}

} // namespace lineatlas::compute
