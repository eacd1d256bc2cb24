#pragma once

#include <span>
#include <string>
#include <string_view>

#include "devices.hpp"
#include "lineatlas/kernel_profile.hpp"

namespace lineatlas::compute {

/// What clGetKernelWorkGroupInfo tells of a built kernel. Members that the driver refuses stay 0.
KernelResources told_of(const cl::Kernel& kernel, const cl::Device& device);

/// The compiler option by which a driver writes registers into the log of a build
/// (cl_nv_compiler_options); empty if it knows none.
std::string register_option(const OpenClDevice& device);

/// The registers of a work-item of `kernel` in such a log, which NVIDIA's assembler writes; 0 if
/// they are not in it.
std::uint32_t registers_in_log(std::string_view log, std::string_view kernel);

/// The vector registers of a work-item of `kernel` in a code object of AMD, an ELF file with notes
/// in MessagePack (LLVM's "User Guide for AMDGPU Backend", code object V3); 0 if `binary` is none.
std::uint32_t registers_in_code_object(std::span<const unsigned char> binary,
                                       std::string_view kernel);

/// CL_DEVICE_REGISTERS_PER_BLOCK_NV (cl_nv_device_attribute_query): registers of a processor of the
/// device, for all its work-items; 0 if the driver does not tell.
std::uint32_t registers_of_processor(const OpenClDevice& device);

} // namespace lineatlas::compute
