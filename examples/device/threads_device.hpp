#pragma once

/// Registers the device "threads" for compute::make_device() and DeviceOptions::compute.
void register_threads_device();
