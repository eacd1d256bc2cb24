#pragma once

/// Makes the device "threads" known: compute::make_device("threads"), DeviceOptions::compute.
void register_threads_device();
