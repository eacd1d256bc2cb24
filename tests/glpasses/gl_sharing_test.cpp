// gl-sharing on an imitated driver (gl_sharing_layer): the order of GL and OpenCL, and that neither
// side uses an object that it does not have.

#include <cstdlib>
#include <numeric>

#include <dlfcn.h>

#include "compare.hpp"
#include "gl_sharing_support.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/interop/gl_context.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"
#include "support/gl_sharing_layer/layer.hpp"

namespace lineatlas::test {
namespace {

using interop::SharingMode;

TEST_F(GlSharing, TheLayerListsTheExtensions) {
    EXPECT_TRUE(device().has_extension("cl_khr_gl_sharing"));
    EXPECT_FALSE(device().has_extension("cl_khr_gl_event"));
    behave("events");
    EXPECT_TRUE(device().has_extension("cl_khr_gl_event"));
}

/// A buffer of numbers that counts as shared, and a device for it.
struct Counted {
    static constexpr std::uint32_t n = 4095;

    explicit Counted(const compute::OpenClDevice& device,
                     SharingMode mode = SharingMode::gl_sharing)
        : opencl(mode == SharingMode::gl_sharing
                     ? compute::make_opencl_backend(device, interop::current_gl_properties())
                     : compute::make_opencl_backend(device)),
          stages(*opencl), sharing(*opencl, mode), table(sharing, compute::table::work_space) {
        table.fit((n + 1) * sizeof(std::uint32_t));
        const std::uint32_t one = 1;
        glClearNamedBufferData(table.gl_to_write(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT,
                               &one);
    }
    void count() { stages.scan(table.compute(), n, compute::ScanKind::saturate); }
    std::vector<std::uint32_t> seen() {
        std::vector<std::uint32_t> result(n + 1);
        glGetNamedBufferSubData(table.gl(), 0, static_cast<GLsizeiptr>(table.room()),
                                result.data());
        return result;
    }
    static std::vector<std::uint32_t> expected() {
        std::vector<std::uint32_t> result(n + 1);
        std::iota(result.begin(), result.end(), 0U);
        return result;
    }

    std::unique_ptr<compute::OpenClBackend> opencl;
    compute::Stages stages;
    interop::Sharing sharing;
    interop::SharedTable table;
};

TEST_F(GlSharing, BothSidesAreWaitedForWithoutEvents) {
    Counted counted{device()};
    take_counts();
    counted.count();
    counted.table.gl();
    const LayerCounts counts = take_counts();
    EXPECT_TRUE(equal(counted.seen(), Counted::expected()));
    EXPECT_EQ(counts.gl_waits, 1U);
    EXPECT_EQ(counts.cl_waits, 1U);
    EXPECT_EQ(counts.acquired, 1U);
    EXPECT_EQ(counts.released, 1U);
    EXPECT_EQ(counts.violations, 0U);
}

TEST_F(GlSharing, NeitherSideIsWaitedForWithEvents) {
    behave("events");
    Counted counted{device()};
    take_counts();
    counted.count();
    counted.table.gl();
    const LayerCounts counts = take_counts();
    EXPECT_TRUE(equal(counted.seen(), Counted::expected()));
    EXPECT_EQ(counts.gl_waits, 0U);
    EXPECT_EQ(counts.cl_waits, 0U);
    EXPECT_EQ(counts.fences, 1U);
    EXPECT_EQ(counts.violations, 0U);
}

TEST_F(GlSharing, BothSidesOfExternalMemoryAreWaitedFor) {
    if (const std::string why = missing_vulkan(); !why.empty()) GTEST_SKIP() << why;
    Counted counted{device(), SharingMode::external_memory};
    take_counts();
    counted.count();
    counted.table.gl();
    const LayerCounts counts = take_counts();
    EXPECT_TRUE(equal(counted.seen(), Counted::expected()));
    EXPECT_EQ(counts.gl_waits, 1U);
    EXPECT_EQ(counts.cl_waits, 1U);
    EXPECT_EQ(counts.acquired, 1U);
    EXPECT_EQ(counts.released, 1U);
    EXPECT_EQ(counts.violations, 0U);
}

TEST_F(GlSharing, ExternalMemoryOfAnySizeArrives) {
    if (const std::string why = missing_vulkan(); !why.empty()) GTEST_SKIP() << why;
    Counted counted{device(), SharingMode::external_memory};
    for (const std::size_t bytes : {1U, 64U, 4095U, 4096U, 70'000U, 5'000'000U}) {
        interop::SharedTable table{counted.sharing, compute::table::work_space};
        std::vector<std::byte> written(bytes), seen(bytes);
        for (std::size_t i = 0; i < bytes; ++i) written[i] = static_cast<std::byte>(i % 251);
        table.fit(bytes);
        table.upload(written);
        glGetNamedBufferSubData(table.gl(), 0, static_cast<GLsizeiptr>(bytes), seen.data());
        EXPECT_EQ(seen, written) << bytes;
    }
    EXPECT_EQ(take_counts().violations, 0U);
}

TEST_F(GlSharing, SeveralTablesWaitOnce) {
    Counted counted{device()};
    interop::SharedTable other{counted.sharing, compute::table::work_space};
    other.fit(64);
    counted.sharing.to_gl({&counted.table, &other}); // there already
    take_counts();
    counted.table.compute();
    other.compute();
    counted.count();
    counted.sharing.to_gl({&counted.table, &other});
    other.gl();
    LayerCounts counts = take_counts();
    EXPECT_EQ(counts.gl_waits, 1U);
    EXPECT_EQ(counts.cl_waits, 1U);
    EXPECT_EQ(counts.acquired, 2U);
    EXPECT_EQ(counts.released, 2U);
    EXPECT_EQ(counts.violations, 0U);
    EXPECT_TRUE(equal(counted.seen(), Counted::expected()));
    counted.table.compute();
    counted.sharing.gl_works(); // a pass that has nothing to do with either
    other.compute();
    counts = take_counts();
    EXPECT_EQ(counts.gl_waits, 2U);
    EXPECT_EQ(counts.violations, 0U);
}

TEST_F(GlSharing, ATableThatHasGrownIsNew) {
    Counted counted{device()};
    interop::SharedTable& table = counted.table;
    counted.count();
    EXPECT_FALSE(table.fit(table.room()));
    EXPECT_TRUE(equal(counted.seen(), Counted::expected()));
    EXPECT_TRUE(table.fit(table.room() + 1)) << "what stood in it is gone";
    table.release();
    EXPECT_FALSE(table);
    EXPECT_EQ(table.room(), 0U);
}

TEST_F(GlSharing, CopiesBringWhatWasWrittenAndNoMore) {
    const auto cpp = compute::make_device("cpp");
    compute::Stages stages{*cpp};
    interop::Sharing sharing{*cpp, SharingMode::copy};
    interop::SharedTable table{sharing, compute::table::work_space};
    constexpr std::size_t count = 16;
    table.fit(count * sizeof(std::uint32_t));
    const auto clear_by_gl = [](GLuint buffer, std::uint32_t value) {
        glClearNamedBufferData(buffer, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &value);
    };
    const auto seen_by_gl = [&] {
        std::vector<std::uint32_t> result(count);
        glGetNamedBufferSubData(table.gl(), 0, count * sizeof(std::uint32_t), result.data());
        return result;
    };
    clear_by_gl(table.gl_to_write(), 1);
    stages.scan(table.compute(), 3, compute::ScanKind::wrap); // of 4 values
    std::vector<std::uint32_t> expected(count, 1);
    std::iota(expected.begin(), expected.begin() + 4, 0U);
    EXPECT_TRUE(equal(seen_by_gl(), expected));
    // A kernel that only reads causes no copy back.
    const auto list = cpp->allocate(64);
    stages.launch_each<compute::kernels::scan_list>(3, {.values = table.compute(), .list = *list});
    clear_by_gl(table.gl(), 7); // without the layer's knowledge
    EXPECT_TRUE(equal(seen_by_gl(), std::vector<std::uint32_t>(count, 7)));
    // Bytes after the used part are not copied back either.
    table.set_size(2 * sizeof(std::uint32_t));
    stages.scan(table.compute(), 3, compute::ScanKind::wrap);
    EXPECT_EQ(seen_by_gl()[3], 7U);
    EXPECT_EQ(seen_by_gl()[1], 0U);
}

// The other tests rely on this: the layer notices every mistake, and data shows some of them.

TEST_F(GlSharing, TheLayerNoticesUseWithoutAcquire) {
    Counted counted{device()};
    const auto memory = interop::make_shared_memory(
        counted.sharing, (Counted::n + 1) * sizeof(std::uint32_t), compute::table::work_space);
    take_counts();
    glFinish();
    counted.stages.scan(memory->compute(), Counted::n, compute::ScanKind::saturate);
    counted.opencl->finish();
    EXPECT_GT(take_counts().violations, 0U);
}

TEST_F(GlSharing, TheLayerNoticesUseAfterRelease) {
    Counted counted{device()};
    compute::Buffer& buffer = counted.table.compute();
    counted.table.gl();
    take_counts();
    std::vector<std::uint32_t> seen(Counted::n + 1);
    counted.opencl->download(buffer, std::as_writable_bytes(std::span{seen}));
    EXPECT_EQ(take_counts().violations, 1U);
}

/// The calls of a handover, one by one.
class GlSharingByHand : public GlSharing {
  protected:
    void SetUp() override {
        GlSharing::SetUp();
        opencl_ = compute::make_opencl_backend(device(), interop::current_gl_properties());
        glCreateBuffers(1, &buffer_);
        glNamedBufferStorage(buffer_, 64, nullptr, GL_DYNAMIC_STORAGE_BIT);
        opened_ = {cl::BufferGL{opencl_->context(), CL_MEM_READ_WRITE, buffer_}};
        take_counts();
    }
    void TearDown() override {
        opened_.clear();
        glDeleteBuffers(1, &buffer_);
    }
    void clear() {
        const std::uint32_t one = 1;
        glClearNamedBufferData(buffer_, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &one);
    }

    std::unique_ptr<compute::OpenClBackend> opencl_;
    GLuint buffer_ = 0;
    std::vector<cl::Memory> opened_;
};

TEST_F(GlSharingByHand, TheRightOrderIsNoViolation) {
    clear();
    glFinish();
    opencl_->queue().enqueueAcquireGLObjects(&opened_);
    opencl_->queue().enqueueReleaseGLObjects(&opened_);
    opencl_->finish();
    clear();
    EXPECT_EQ(take_counts().violations, 0U);
}

TEST_F(GlSharingByHand, AcquireWithoutFinishIsNoticed) {
    glFinish();
    clear();
    opencl_->queue().enqueueAcquireGLObjects(&opened_);
    EXPECT_EQ(take_counts().violations, 1U);
}

TEST_F(GlSharingByHand, AFenceThatIsNotAwaitedDoesNotCount) {
    clear();
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    opencl_->queue().enqueueAcquireGLObjects(&opened_);
    EXPECT_EQ(take_counts().violations, 1U);
    glDeleteSync(fence);
}

TEST_F(GlSharingByHand, GlBeforeFinishIsNoticed) {
    glFinish();
    opencl_->queue().enqueueAcquireGLObjects(&opened_);
    opencl_->queue().enqueueReleaseGLObjects(&opened_);
    clear();
    EXPECT_EQ(take_counts().violations, 1U);
    opencl_->finish();
}

TEST_F(GlSharingByHand, ReleaseWithoutAcquireIsNoticed) {
    opencl_->queue().enqueueReleaseGLObjects(&opened_);
    EXPECT_EQ(take_counts().violations, 1U);
    opencl_->finish();
}

/// With and without cl_khr_gl_event, and by external memory.
class GlSharingPictures : public GlSharing, public testing::WithParamInterface<const char*> {
  protected:
    std::vector<std::uint8_t> draw(Renderer& renderer, const Camera& camera,
                                   const FrameOptions& options) {
        canvas_.clear(glm::vec4{1});
        const FrameStats stats = renderer.draw(camera, options, canvas_.framebuffer());
        EXPECT_TRUE(options.method != Method::atlas || stats.runs > 0) << "an empty picture";
        return canvas_.read();
    }
    void expect_same(const char* scene, const std::vector<FrameOptions>& all) {
        Renderer shared{{.interop = mode_}};
        Renderer copied{{.interop = "copy"}};
        shared.set_lines(scene_lines(scene));
        copied.set_lines(scene_lines(scene));
        take_counts();
        for (const FrameOptions& options : all) {
            for (const NamedCamera& view : scene_cameras(scene, canvas_.size())) {
                SCOPED_TRACE(std::string{scene} + ", " + view.name);
                EXPECT_TRUE(
                    equal(draw(shared, view.camera, options), draw(copied, view.camera, options)));
            }
        }
        const LayerCounts counts = take_counts();
        EXPECT_GT(counts.acquired, 0U);
        EXPECT_EQ(counts.violations, 0U);
    }

    std::string mode_;
    gl::Canvas canvas_{{400, 300}};
};

TEST_P(GlSharingPictures, EqualThoseOfCopies) {
    mode_ = "gl-sharing";
    if (GetParam() == std::string_view{"external"}) {
        if (const std::string why = missing_vulkan(); !why.empty()) GTEST_SKIP() << why;
        mode_ = "external-memory";
    }
    behave(GetParam());
    FrameOptions styled{
        .style = {.filter = {.fill_holes = 4, .drop_runs = 4, .overshoot = 12, .halo = 3}}};
    styled.style.density.limit = 0.2F;
    FrameOptions hidden;
    hidden.style.hidden = true;
    const std::vector<FrameOptions> all{{.forms = {.atlas = StageForm::raster}},
                                        {.forms = {.atlas = StageForm::compute}},
                                        styled,
                                        hidden,
                                        {.method = Method::spine},
                                        {.intervals = KeptIntervals::all}};
    for (const char* scene : {"clevis", "ship"}) expect_same(scene, all);
}

INSTANTIATE_TEST_SUITE_P(Driver, GlSharingPictures, testing::Values("", "events", "external"),
                         [](const auto& name) {
                             return std::string{*name.param == '\0' ? "waits" : name.param};
                         });

} // namespace
} // namespace lineatlas::test
