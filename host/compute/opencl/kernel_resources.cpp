#include "kernel_resources.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <optional>

#include <elf.h>
#include <nlohmann/json.hpp>

namespace lineatlas::compute {
namespace {

/// An answer of clGetKernelWorkGroupInfo; 0 if the driver refuses.
template <class Answer>
Answer asked(const cl::Kernel& kernel, const cl::Device& device, cl_kernel_work_group_info what) {
    Answer answer{};
    const cl_int status =
        clGetKernelWorkGroupInfo(kernel(), device(), what, sizeof answer, &answer, nullptr);
    return status == CL_SUCCESS ? answer : Answer{};
}

/// The number that `text` begins with, after spaces; 0 if it begins with none.
std::uint32_t number_in(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    std::uint32_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// A struct at a place of a file; nothing if the file ends before it does.
template <class T>
std::optional<T> read_at(std::span<const unsigned char> file, std::uint64_t place) {
    if (place > file.size() || file.size() - place < sizeof(T)) return std::nullopt;
    T value;
    std::memcpy(&value, file.data() + place, sizeof value);
    return value;
}

std::uint64_t padded(std::uint64_t size) {
    return (size + 3) / 4 * 4;
}

/// The content of AMD's note among the notes of a section; empty if it has none.
std::span<const unsigned char> note_of_amd(std::span<const unsigned char> notes) {
    constexpr std::uint32_t metadata = 32; // NT_AMDGPU_METADATA
    constexpr std::string_view owner{"AMDGPU", 7};
    std::uint64_t place = 0;
    while (const auto header = read_at<Elf64_Nhdr>(notes, place)) {
        const std::uint64_t name = place + sizeof *header;
        const std::uint64_t content = name + padded(header->n_namesz);
        if (content > notes.size() || header->n_descsz > notes.size() - content) break;
        const std::string_view own{reinterpret_cast<const char*>(notes.data() + name),
                                   header->n_namesz};
        if (header->n_type == metadata && own == owner)
            return notes.subspan(content, header->n_descsz);
        place = content + padded(header->n_descsz);
    }
    return {};
}

/// The content of AMD's note in an ELF file; empty if it has none.
std::span<const unsigned char> metadata_in(std::span<const unsigned char> file) {
    const auto header = read_at<Elf64_Ehdr>(file, 0);
    if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0) return {};
    for (std::uint64_t i = 0; i < header->e_shnum; ++i) {
        const auto section = read_at<Elf64_Shdr>(file, header->e_shoff + i * sizeof(Elf64_Shdr));
        if (!section || section->sh_type != SHT_NOTE || section->sh_offset > file.size()) continue;
        const std::uint64_t left = file.size() - section->sh_offset;
        const auto note =
            note_of_amd(file.subspan(section->sh_offset, std::min(section->sh_size, left)));
        if (!note.empty()) return note;
    }
    return {};
}

} // namespace

KernelResources told_of(const cl::Kernel& kernel, const cl::Device& device) {
    const auto group = asked<std::size_t>(kernel, device, CL_KERNEL_WORK_GROUP_SIZE);
    const auto multiple =
        asked<std::size_t>(kernel, device, CL_KERNEL_PREFERRED_WORK_GROUP_SIZE_MULTIPLE);
    return {.largest_group = static_cast<std::uint32_t>(group),
            .multiple = static_cast<std::uint32_t>(multiple),
            .local_bytes = asked<cl_ulong>(kernel, device, CL_KERNEL_LOCAL_MEM_SIZE),
            .private_bytes = asked<cl_ulong>(kernel, device, CL_KERNEL_PRIVATE_MEM_SIZE)};
}

std::string register_option(const OpenClDevice& device) {
    return device.has_extension("cl_nv_compiler_options") ? "-cl-nv-verbose" : "";
}

std::uint32_t registers_in_log(std::string_view log, std::string_view kernel) {
    const std::string entry = "entry function '" + std::string{kernel} + "'";
    const std::size_t begin = log.find(entry);
    if (begin == log.npos) return 0;
    const std::string_view rest = log.substr(begin + entry.size());
    const std::string_view own = rest.substr(0, rest.find("entry function '"));
    constexpr std::string_view used = "Used ";
    const std::size_t place = own.find(used);
    return place != own.npos ? number_in(own.substr(place + used.size())) : 0;
}

std::uint32_t registers_in_code_object(std::span<const unsigned char> binary,
                                       std::string_view kernel) {
    const auto note = metadata_in(binary);
    const auto json =
        nlohmann::json::from_msgpack(note.begin(), note.end(), /*strict=*/true, /*throws=*/false);
    const auto member = [](const nlohmann::json& of, const char* name) {
        return of.is_object() && of.contains(name) ? of[name] : nlohmann::json{};
    };
    for (const nlohmann::json& own : member(json, "amdhsa.kernels")) {
        const nlohmann::json registers = member(own, ".vgpr_count");
        if (member(own, ".name") == kernel && registers.is_number_unsigned())
            return registers.get<std::uint32_t>();
    }
    return 0;
}

std::uint32_t registers_of_processor(const OpenClDevice& device) {
    constexpr cl_device_info registers_per_block = 0x4002; // CL/cl_ext.h may lack it
    if (!device.has_extension("cl_nv_device_attribute_query")) return 0;
    cl_uint registers = 0;
    const cl_int status = clGetDeviceInfo(device.device(), registers_per_block, sizeof registers,
                                          &registers, nullptr);
    return status == CL_SUCCESS ? registers : 0;
}

} // namespace lineatlas::compute
