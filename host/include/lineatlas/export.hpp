#pragma once

/// @file
/// The marks of what the shared libraries export, and of what they hide.

/// Marks a symbol that the shared libraries export; all other symbols are hidden.
#define LINEATLAS_API __attribute__((visibility("default")))
/// Marks a class within an exported one that stays hidden.
#define LINEATLAS_LOCAL __attribute__((visibility("hidden")))
