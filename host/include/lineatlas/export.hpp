#pragma once

/// What the shared libraries export; all else in them is hidden.
#define LINEATLAS_API __attribute__((visibility("default")))
#define LINEATLAS_LOCAL __attribute__((visibility("hidden")))
