// Uses the library in loops, like a program that runs for weeks: visibility on four threads,
// renderers that are made and destroyed, callbacks that throw, and line sets of changing sizes.
// Results must stay the same, and memory must not grow. `loops 1000` is a long run; the suite runs
// a short one.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <malloc.h>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "io/reader_protocol.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/visibility.hpp"
#include "support/held_memory.hpp"

namespace {

using namespace lineatlas;

constexpr glm::ivec2 size{320, 240};

long held_memory() {
    malloc_trim(0);
    return test::held_memory(); // KiB
}

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what);
}

/// Runs `step(i)` for i below `count`. Compares memory before and after the second half.
void loop(const std::string& name, int count, const std::function<void(int)>& step) {
    constexpr long most_growth = 8 << 10; // KiB that drivers and allocators keep
    const int half = count / 2;
    for (int i = 0; i < half; ++i) step(i);
    const long before = held_memory();
    for (int i = half; i < count; ++i) step(i);
    const long growth = held_memory() - before;
    std::cout << name << ": " << count << " times, " << before / 1024 << " MiB held, " << growth
              << " KiB more at the end" << std::endl;
    if (growth > most_growth && !reader::sanitized) fail(name + ": memory grows");
}

/// A square of `count` by `count` bent quads.
LineSet grid(int count) {
    Mesh mesh;
    for (int y = 0; y <= count; ++y)
        for (int x = 0; x <= count; ++x) mesh.positions.emplace_back(x, y, (x % 2 + y % 2) * 0.4F);
    const auto row = static_cast<unsigned>(count + 1);
    for (unsigned y = 0; y + 1 < row; ++y) {
        for (unsigned x = 0; x + 1 < row; ++x) {
            const unsigned corner = y * row + x;
            mesh.triangles.emplace_back(corner, corner + 1, corner + row + 1);
            mesh.triangles.emplace_back(corner, corner + row + 1, corner + row);
        }
    }
    return extract_lines(mesh);
}

struct Subject {
    explicit Subject(const char* name)
        : scene(make_scene(name)), lines(extract_lines(scene.mesh)) {}

    Camera camera(int i) const {
        return make_camera(scene.view(static_cast<float>(i % 20) / 20), size, lines.bounds);
    }

    Scene scene;
    LineSet lines;
};

void visibility_on_threads(const Subject& subject, int count) {
    std::vector<std::size_t> known;
    for (int i = 0; i < 20; ++i)
        known.push_back(LineVisibility{subject.lines}.find(subject.camera(i)).size());
    loop("visibility on four threads", count / 4, [&](int i) {
        std::atomic<bool> equal = true;
        std::vector<std::thread> threads;
        for (int thread = 0; thread < 4; ++thread) {
            threads.emplace_back([&, number = i + 5 * thread] {
                LineVisibility visibility{subject.lines};
                const std::size_t pieces = visibility.find(subject.camera(number)).size();
                if (pieces != known[static_cast<std::size_t>(number % 20)]) equal = false;
            });
        }
        for (std::thread& thread : threads) thread.join();
        if (!equal) fail("a thread finds other pieces");
    });
}

/// The picture that a renderer draws.
std::vector<std::uint8_t> picture_by(Renderer& renderer, const Subject& subject,
                                     gl::Canvas& canvas) {
    canvas.clear({1, 1, 1, 1});
    renderer.draw(subject.camera(3), {}, canvas.framebuffer());
    return canvas.read();
}

void renderers_made(const Subject& subject, gl::Canvas& canvas, int count) {
    std::vector<std::uint8_t> known;
    for (const char* backend : {"cpp", "opencl"}) {
        const DeviceOptions device{.compute = backend};
        loop(std::string{"renderers on "} + backend, count / 4, [&](int) {
            Renderer renderer{device};
            renderer.set_lines(subject.lines);
            const auto picture = picture_by(renderer, subject, canvas);
            if (known.empty()) known = picture;
            if (picture != known) fail("a renderer draws another picture");
        });
    }
}

void callbacks_that_throw(const Subject& subject, gl::Canvas& canvas, int count) {
    const std::runtime_error planted{"planted"};
    const auto expect_thrown = [&](const std::function<void()>& call) {
        try {
            call();
        } catch (const std::runtime_error& error) {
            if (std::string{error.what()} == planted.what()) return;
            throw;
        }
        fail("what a callback throws is lost");
    };
    LineVisibility visibility{subject.lines};
    const std::size_t pieces = visibility.find(subject.camera(3)).size();
    Renderer renderer;
    renderer.set_lines(subject.lines);
    const auto known = picture_by(renderer, subject, canvas);
    loop("callbacks that throw", count, [&](int i) {
        int left = i % 4;
        const Progress late = [&](float) -> bool { return left-- > 0 ? true : throw planted; };
        expect_thrown([&] { visibility.find(subject.camera(3), {}, late); });
        TileTarget target{.framebuffer = canvas.framebuffer(), .tile_size = 128};
        const auto none = [](const PictureTile&) {};
        target.begin = target.end = none;
        const auto tile = [&](const PictureTile&) {
            if (left-- <= 0) throw planted;
        };
        left = i % 4;
        (i % 2 == 0 ? target.begin : target.end) = tile;
        expect_thrown([&] { renderer.draw_tiles(subject.camera(3), {}, target); });
        if (visibility.find(subject.camera(3)).size() != pieces) fail("other pieces after a throw");
        if (picture_by(renderer, subject, canvas) != known) fail("another picture after a throw");
    });
}

void sizes_that_change(const Subject& subject, gl::Canvas& canvas, int count) {
    std::vector<LineSet> sets;
    for (const int quads : {1, 90, 7, 40, 2, 60}) sets.push_back(grid(quads));
    Renderer renderer;
    LineVisibility visibility{sets[0]};
    renderer.set_lines(subject.lines);
    const auto known = picture_by(renderer, subject, canvas);
    loop("line sets of other sizes", count, [&](int i) {
        const LineSet& lines = sets[static_cast<std::size_t>(i) % sets.size()];
        renderer.set_lines(lines);
        visibility.set_lines(lines);
        const Camera camera = make_camera(subject.scene.view(0), size, lines.bounds);
        renderer.draw(camera, {}, canvas.framebuffer());
        visibility.find(camera);
    });
    renderer.set_lines(subject.lines);
    if (picture_by(renderer, subject, canvas) != known) fail("another picture at the end");
}

} // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
    try {
        const Subject subject{"clevis"};
        visibility_on_threads(subject, count);
        const gl::HeadlessContext context;
        gl::Canvas canvas{size};
        renderers_made(subject, canvas, count);
        callbacks_that_throw(subject, canvas, count);
        sizes_that_change(subject, canvas, count);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
