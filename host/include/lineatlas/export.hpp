#pragma once

/// Marks a symbol that the shared libraries export; all other symbols are hidden.
#define LINEATLAS_API __attribute__((visibility("default")))
#define LINEATLAS_LOCAL __attribute__((visibility("hidden")))
