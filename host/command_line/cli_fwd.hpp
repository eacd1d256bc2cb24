#pragma once

/// CLI11's headers cost a source three seconds, so headers of options do without.
namespace CLI {
class App;
}
