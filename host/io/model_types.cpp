#include "model_types.hpp"

#include <algorithm>
#include <vector>

#include "extension.hpp"

namespace lineatlas {

const ModelType* find_model_type(std::string_view extension) {
    const auto* const found = std::ranges::find(model_types, extension, &ModelType::extension);
    return found != model_types.end() ? found : nullptr;
}

std::string model_extensions() {
    std::string text;
    for (const ModelType& type : model_types) {
        const bool last = &type == &model_types.back();
        text += text.empty() ? "" : last ? " and " : ", ";
        text += type.extension;
    }
    return text;
}

std::string model_type_names(std::string_view last) {
    std::vector<std::string_view> names;
    for (const ModelType& type : model_types)
        if (names.empty() || names.back() != type.name) names.push_back(type.name);
    std::string text;
    for (const std::string_view name : names) {
        if (!text.empty()) text += name == names.back() ? last : ", ";
        text += name;
    }
    return text;
}

UsualUp usual_up(const std::filesystem::path& model) {
    const ModelType* const type = find_model_type(lower_extension(model));
    return type != nullptr ? type->up : UsualUp::y;
}

} // namespace lineatlas
