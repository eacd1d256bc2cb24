#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tuning.hpp"

namespace lineatlas::compute {

/// A value of the table.
struct TuningField {
    std::string_view name;
    std::variant<bool Tuning::*, std::uint32_t Tuning::*> member;
    std::vector<std::uint32_t> allowed{}; ///< empty: any from 1 to `most`
    std::uint32_t most = 0;
};

/// All fields, in the order of the table.
std::span<const TuningField> tuning_fields();

void set_value(Tuning& tuning, const TuningField& field, std::uint32_t value);

/// The field's value as it stands in a table: "true" or "64".
std::string text_of(const TuningField& field, const Tuning& tuning);

/// The rows of a tuning file; see kernels/tuning.toml.
class TuningTable {
  public:
    /// Throws FileError, naming `place`, the line and the field, if `text` is not right.
    TuningTable(std::string_view text, const std::string& place);

    /// Throws FileError if the rows that match leave a value out.
    Tuning values_for(const OpenClDevice& device) const;

    /// A device that each row matches; for a row of any type, one device of each type. Names that
    /// the row leaves open are empty.
    std::vector<OpenClDevice> examples() const;

  private:
    struct Row {
        OpenClDevice parts; ///< parts of the names of devices that it matches
        std::string type;   ///< type of the devices; empty: any
        bool matches(const OpenClDevice& device) const;

        std::vector<std::pair<const TuningField*, std::uint32_t>> values;
    };

    std::string place_;
    std::vector<Row> rows_;

    friend class TuningReader;
};

} // namespace lineatlas::compute
