// strokes, the compute form: coverage known by hand.

#include "stage_test.hpp"

#include <algorithm>

namespace lineatlas::test {
namespace {

class Strokes : public StageTest {};
std::vector<TestDevice> devices_in_both_forms() {
    std::vector<TestDevice> devices = test_devices();
    devices.push_back(cpp_as_gpu());
    return devices;
}
INSTANTIATE_TEST_SUITE_P(OnDevice, Strokes, testing::ValuesIn(devices_in_both_forms()),
                         [](const auto& info) { return info.param.name; });

using Coverage = std::vector<std::uint8_t>;
using Runs = std::vector<Run>;

constexpr glm::ivec2 size{200, 150};

/// A run between two points, visible all along, cut square at both ends.
Run run_between(glm::vec2 a, glm::vec2 b) {
    Run run{};
    for (int k = 0; k < 2; ++k) {
        run.start[k] = a[k];
        run.end[k] = b[k];
    }
    run.end_arc = std::hypot(b.x - a.x, b.y - a.y);
    run.samples = 8;
    run.end_sample = 8;
    return run;
}

Run with_ends(Run run, unsigned start, unsigned end) {
    run.flags |= start << LA_RUN_START_SHIFT | end << LA_RUN_END_SHIFT;
    return run;
}

struct How {
    float width = 2;
    float opacity = 1;
    std::uint32_t end_kinds = LA_STROKES_ROUND_PATHS;
    bool hidden = false;
    std::uint32_t pen = LA_ALL_PENS;
    std::vector<float> mark{}; ///< as StrokeArgs has it
    float repeat_length = 1;
    PictureTile part{{0, 0}, size};
};

/// Runs over what others have left.
class Drawing {
  public:
    Drawing(compute::Stages& stages, const How& how) : stages_(stages), how_(how) {
        const auto pixels = static_cast<std::size_t>(how.part.size.x * how.part.size.y);
        pitch_ = static_cast<std::uint32_t>(pixels);
        coverage_ = to_device(device(), Coverage(2 * pixels, 77)); // it is cleared
        const glm::ivec2 tiles = compute::part_tiles(how.part).count;
        tile_count_ = static_cast<std::size_t>(tiles.x * tiles.y);
        shown_ = to_device(device(), std::vector<la_uint>(2 * tile_count_, 77));
    }

    void draw(const Runs& runs, const Coverage& alpha = Coverage(8, 255)) {
        FrameRecord record{};
        record.points[0] = static_cast<la_uint>(runs.size());
        const auto run_table = to_device(device(), runs);
        const auto records = to_device(device(), std::vector{record});
        const auto samples = to_device(device(), alpha);
        const glm::vec2 viewport{size};
        const auto ends =
            device().allocate(compute::stroke_ends(device().tuning(), viewport) * sizeof(la_uint));
        const auto entries = device().allocate(capacity * sizeof(la_uint));
        const auto total = device().allocate(sizeof(la_uint));
        const compute::StrokeLists lists{*ends, *entries, *total, capacity};
        const auto room = static_cast<std::uint32_t>(run_table->size() / sizeof(Run));
        const compute::RunTable table{*run_table, *records, room};
        stages_.list_strokes({table, viewport, 0.5F * how_.width, lists});
        const la_uint ends_total =
            read_back<la_uint>(device(), *ends, compute::stroke_ends(device().tuning(), viewport))
                .back();
        EXPECT_EQ(read_back<la_uint>(device(), *total, 1)[0], ends_total);
        const auto mark = to_device(device(), how_.mark.empty() ? std::vector{0.0F} : how_.mark);
        stages_.draw_strokes({.runs = table,
                              .lists = lists,
                              .alpha = *samples,
                              .viewport = viewport,
                              .part = how_.part,
                              .half_width = 0.5F * how_.width,
                              .opacity = how_.opacity,
                              .end_kinds = how_.end_kinds,
                              .hidden = how_.hidden,
                              .pen = how_.pen,
                              .mark = how_.mark.empty() ? nullptr : mark.get(),
                              .mark_length = static_cast<std::uint32_t>(
                                  std::max<std::size_t>(how_.mark.size(), 2) - 2),
                              .repeat_length = how_.repeat_length,
                              .again = again_,
                              .coverage = *coverage_,
                              .shown = *shown_,
                              .layer = 1, // the first belongs to another pen
                              .pitch = pitch_});
        again_ = true;
    }

    Coverage read() {
        const Coverage all = read_back<std::uint8_t>(device(), *coverage_, 2 * pitch_);
        EXPECT_EQ(std::ranges::count(all.begin(), all.begin() + pitch_, 77), pitch_);
        return {all.begin() + pitch_, all.end()};
    }
    std::vector<la_uint> shown() {
        const auto all = read_back<la_uint>(device(), *shown_, 2 * tile_count_);
        return {all.begin() + static_cast<std::ptrdiff_t>(tile_count_), all.end()};
    }

  private:
    static constexpr std::uint32_t capacity = 4096;
    compute::Device& device() { return stages_.device(); }

    compute::Stages& stages_;
    How how_;
    bool again_ = false;
    std::uint32_t pitch_ = 0;
    std::size_t tile_count_ = 0;
    std::unique_ptr<compute::Buffer> coverage_, shown_;
};

Coverage draw(compute::Stages& stages, const Runs& runs, const How& how = {},
              const Coverage& alpha = Coverage(8, 255)) {
    Drawing drawing{stages, how};
    drawing.draw(runs, alpha);
    return drawing.read();
}

int at(const Coverage& coverage, int x, int y) {
    return coverage[static_cast<std::size_t>(y * size.x + x)];
}

std::size_t touched(const Coverage& coverage) {
    return coverage.size() -
           static_cast<std::size_t>(std::ranges::count(coverage, std::uint8_t{0}));
}

TEST_P(Strokes, AHorizontalOneCoversItsRows) {
    // Through the middles of pixels: one row whole, those beside it by half.
    const Coverage middle = draw(stages(), {run_between({10, 20.5F}, {50, 20.5F})});
    for (int x = 0; x < size.x; ++x) {
        const bool within = x >= 10 && x < 50;
        EXPECT_EQ(at(middle, x, 19), within ? 128 : 0) << x; // 127.5 goes to the even one
        EXPECT_EQ(at(middle, x, 20), within ? 255 : 0) << x;
        EXPECT_EQ(at(middle, x, 21), within ? 128 : 0) << x;
    }
    EXPECT_EQ(touched(middle), 3U * 40U);
    // Between two rows: both whole, nothing else.
    const Coverage between = draw(stages(), {run_between({10, 20}, {50, 20})});
    EXPECT_EQ(at(between, 30, 19), 255);
    EXPECT_EQ(at(between, 30, 20), 255);
    EXPECT_EQ(touched(between), 2U * 40U);
}

TEST_P(Strokes, AThinOneNeverCoversAPixelWhole) {
    const Coverage thin = draw(stages(), {run_between({10, 20.5F}, {50, 20.5F})}, {.width = 0.5F});
    EXPECT_EQ(at(thin, 30, 20), 128);
    EXPECT_EQ(touched(thin), 40U);
    const Coverage pale =
        draw(stages(), {run_between({10, 20.5F}, {50, 20.5F})}, {.opacity = 0.2F});
    EXPECT_EQ(at(pale, 30, 20), 51);
}

TEST_P(Strokes, ASlantedOneCoversByDistance) {
    const Coverage slanted = draw(stages(), {run_between({10, 10}, {50, 50})});
    const float diagonal = std::sqrt(0.5F); // pixels from the line per pixel beside it
    for (int beside = -4; beside <= 4; ++beside) {
        const float distance = std::fabs(static_cast<float>(beside)) * diagonal;
        const auto expected = std::lround(255 * std::clamp(1.5F - distance, 0.0F, 1.0F));
        EXPECT_EQ(at(slanted, 30 + beside, 30), expected) << beside;
        EXPECT_EQ(at(slanted, 30, 30 + beside), expected) << beside;
    }
}

TEST_P(Strokes, OneOverAnotherAddsWhatIsLeft) {
    const How pale{.opacity = 0.4F};
    const Coverage cross =
        draw(stages(),
             {run_between({10, 20.5F}, {50, 20.5F}), run_between({30.5F, 0}, {30.5F, 40})}, pale);
    EXPECT_EQ(at(cross, 20, 20), 102);
    EXPECT_EQ(at(cross, 30, 20), 163); // 102 + 0.4 (255 - 102) = 163.2
}

TEST_P(Strokes, TilesAndPartsAreSeamless) {
    // Across tiles of 64 pixels in both directions, and lines that run on their borders.
    const Runs runs{run_between({3, 7}, {197, 141}), run_between({64, 2}, {64, 148}),
                    run_between({1, 128}, {199, 128}), run_between({190, 3}, {9, 140})};
    const Coverage whole = draw(stages(), runs);
    EXPECT_EQ(at(whole, 63, 30), 255);
    EXPECT_EQ(at(whole, 64, 30), 255);
    EXPECT_EQ(at(whole, 62, 20), 0);
    for (const PictureTile part : {PictureTile{{0, 0}, {64, 64}}, PictureTile{{37, 50}, {90, 81}},
                                   PictureTile{{128, 64}, {72, 86}}}) {
        How how{};
        how.part = part;
        const Coverage found = draw(stages(), runs, how);
        std::size_t different = 0;
        for (int y = 0; y < part.size.y; ++y) {
            for (int x = 0; x < part.size.x; ++x) {
                const int own = found[static_cast<std::size_t>(y * part.size.x + x)];
                different += own != at(whole, part.low.x + x, part.low.y + y) ? 1 : 0;
            }
        }
        EXPECT_EQ(different, 0U);
    }
}

TEST_P(Strokes, OnePieceOrSeveralAreTheSame) {
    Runs runs;
    for (int i = 0; i < 300; ++i) {
        const auto k = static_cast<float>(i);
        runs.push_back(
            run_between({20 + std::fmod(k * 7.3F, 160.0F), 10 + std::fmod(k * 3.7F, 130.0F)},
                        {20 + std::fmod(k * 5.1F, 160.0F), 10 + std::fmod(k * 9.1F, 130.0F)}));
    }
    const How pale{.opacity = 0.3F};
    const Coverage whole = draw(stages(), runs, pale);
    Drawing pieces{stages(), pale};
    pieces.draw({runs.begin(), runs.begin() + 113});
    pieces.draw({runs.begin() + 113, runs.end()});
    EXPECT_EQ(pieces.read(), whole);
    EXPECT_GT(touched(whole), 10'000U);
}

TEST_P(Strokes, ThosePartlyVisibleFade) {
    // Samples of 5 pixels: hidden ones, then visible. Their middles lie at 12.5, 17.5, ...
    const Coverage alpha{0, 0, 0, 0, 255, 255, 255, 255};
    const Runs runs{run_between({10, 20.5F}, {50, 20.5F})};
    const Coverage visible = draw(stages(), runs, {}, alpha);
    EXPECT_EQ(at(visible, 27, 20), 0);   // the middle of the last hidden one
    EXPECT_EQ(at(visible, 28, 20), 153); // a fifth further: 255 * 3 * 1/5
    EXPECT_EQ(at(visible, 29, 20), 255); // a third is enough
    const Coverage hidden = draw(stages(), runs, {.hidden = true}, alpha);
    EXPECT_EQ(at(hidden, 27, 20), 255);
    EXPECT_EQ(at(hidden, 28, 20), 102);
    EXPECT_EQ(at(hidden, 29, 20), 0);
}

TEST_P(Strokes, EndsAreSquareRoundOrCut) {
    const auto ended = with_ends(run_between({20, 20.5F}, {60, 20.5F}), LA_END_PATH, LA_END_PATH);
    const Coverage round = draw(stages(), {ended}, {.width = 10});
    EXPECT_EQ(at(round, 15, 20), 255); // 4.5 from the end, of 5
    EXPECT_EQ(at(round, 14, 20), 0);   // 5.5
    EXPECT_EQ(at(round, 16, 24), 47);  // hypot(3.5, 4) = 5.315: 0.185 of a pixel
    EXPECT_EQ(at(round, 16, 23), 227); // hypot(3.5, 3) = 4.61: 0.89
    const Coverage cut = draw(stages(), {ended}, {.width = 10, .end_kinds = LA_STROKES_EXACT_ENDS});
    EXPECT_EQ(at(cut, 20, 20), 255);
    EXPECT_EQ(at(cut, 19, 20), 0);
    auto half = ended;
    half.start[0] = 20.25F;
    EXPECT_EQ(at(draw(stages(), {half}, {.width = 10, .end_kinds = LA_STROKES_EXACT_ENDS}), 20, 20),
              191); // three quarters: 191.25
}

TEST_P(Strokes, AtAJoinEachPixelBelongsToOne) {
    // A right angle; both end on its bisector, whose corner is at (1, 1) for half-width 1.
    auto across = with_ends(run_between({20, 60}, {60, 60}), LA_END_CLIPPED, LA_END_JOIN);
    auto up = with_ends(run_between({60, 60}, {60, 100}), LA_END_JOIN, LA_END_CLIPPED);
    for (int k = 0; k < 2; ++k) across.end_corner[k] = up.start_corner[k] = k == 0 ? -1.0F : 1.0F;
    const Coverage joined = draw(stages(), {across, up}, {.width = 8, .opacity = 0.5F});
    std::size_t once = 0;
    for (const std::uint8_t value : joined) {
        EXPECT_LE(value, 128);
        once += value == 128 ? 1 : 0;
    }
    // Rows of 8 pixels: 44 along x with the outer corner, and 40 up less the inner half.
    EXPECT_EQ(once, 8U * 44U + 8U * 36U);
}

TEST_P(Strokes, EachPenDrawsItsOwn) {
    auto first = run_between({10, 20.5F}, {50, 20.5F});
    auto second = run_between({10, 40.5F}, {50, 40.5F});
    second.flags |= 1U << LA_RUN_PEN_SHIFT;
    const Coverage of_second = draw(stages(), {first, second}, {.pen = 1});
    EXPECT_EQ(at(of_second, 30, 20), 0);
    EXPECT_EQ(at(of_second, 30, 40), 255);
}

TEST_P(Strokes, AMarkRepeatsAlongTheLine) {
    // Four values over 8 pixels, 0 0 1 1: their middles lie at 1, 3, 5, 7, with lines between them.
    const How dashed{.mark = {1, 0, 0, 1, 1, 0}, .repeat_length = 8};
    const Coverage dashes = draw(stages(), {run_between({16, 20.5F}, {80, 20.5F})}, dashed);
    const int expected[] = {64, 0, 0, 64, 191, 255, 255, 191};
    for (int x = 16; x < 80; ++x) EXPECT_NEAR(at(dashes, x, 20), expected[x % 8], 1) << x;
}

TEST_P(Strokes, EmptyTilesAreMarkedSo) {
    Drawing drawing{stages(), {}};
    drawing.draw({run_between({70, 20.5F}, {100, 20.5F})});
    EXPECT_EQ(touched(drawing.read()), 3U * 30U);
    const std::vector<la_uint> expected{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    EXPECT_EQ(drawing.shown(), expected);
}

TEST_P(Strokes, TilesAndPixelsGiveTheSameBits) {
    DeviceStages other{in_other_form(GetParam())};
    Runs runs;
    for (int i = 0; i < 400; ++i) {
        const auto k = static_cast<float>(i);
        const glm::vec2 start{std::fmod(k * 7.3F, 200.0F), std::fmod(k * 3.7F, 150.0F)};
        const glm::vec2 end{std::fmod(k * 5.1F, 200.0F), std::fmod(k * 9.1F, 150.0F)};
        lineatlas::Run run = with_ends(run_between(start, end),
                                       i % 3 == 0 ? LA_END_PATH : LA_END_HIDDEN, LA_END_CLIPPED);
        run.flags |= static_cast<la_uint>(i % 2) << LA_RUN_PEN_SHIFT;
        runs.push_back(run);
    }
    const Coverage alpha{0, 40, 255, 255, 255, 80, 255, 255};
    const PictureTile part{{37, 50}, {91, 83}};
    for (const How& how :
         {How{}, How{.width = 7, .opacity = 0.3F, .pen = 1},
          How{.end_kinds = LA_STROKES_EXACT_ENDS, .hidden = true, .part = part},
          How{.width = 0.7F, .mark = {1, 0, 0, 1, 1, 0}, .repeat_length = 8, .part = part}}) {
        Drawing own{stages(), how}, of_other{other.stages, how};
        for (Drawing* drawing : {&own, &of_other}) {
            drawing->draw({runs.begin(), runs.begin() + 250});
            drawing->draw({runs.begin() + 250, runs.end()}, alpha);
        }
        const Coverage drawn = own.read();
        EXPECT_GT(touched(drawn), 1000U);
        EXPECT_EQ(drawn, of_other.read());
        EXPECT_EQ(own.shown(), of_other.shown());
    }
}

} // namespace
} // namespace lineatlas::test
