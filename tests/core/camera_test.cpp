#include "lineatlas/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "lineatlas/error.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float frame_margin = 0.92F; // of half the frame; see frame_points

const Bounds unit_box{.min = {-1, -1, -1}, .max = {1, 1, 1}};
const View usual{.eye = {3, 2, 5}};

Bounds box_of(std::span<const glm::vec3> points) {
    Bounds box;
    for (const glm::vec3& p : points) {
        box.min = glm::min(box.min, p);
        box.max = glm::max(box.max, p);
    }
    return box;
}

glm::vec3 device_position(const Camera& camera, glm::vec3 point) {
    const glm::vec4 clip = camera.clip_from_world() * glm::vec4{point, 1};
    EXPECT_GT(clip.w, 0) << "behind the eye";
    return glm::vec3{clip} / clip.w;
}

/// The box of what the camera sees of the points, in normalised device coordinates.
Bounds outline_of(const Camera& camera, std::span<const glm::vec3> points) {
    std::vector<glm::vec3> seen;
    for (const glm::vec3& p : points) seen.push_back(device_position(camera, p));
    return box_of(seen);
}

TEST(MakeCamera, PutsTheTargetInTheMiddleAndUpAbove) {
    const Camera camera = make_camera(usual, {800, 400}, unit_box);
    EXPECT_EQ(camera.size, glm::ivec2(800, 400));
    const glm::vec3 middle = device_position(camera, usual.target);
    EXPECT_NEAR(middle.x, 0, 1e-6);
    EXPECT_NEAR(middle.y, 0, 1e-6);
    const glm::vec3 above = device_position(camera, usual.target + 0.5F * usual.up);
    EXPECT_NEAR(above.x, 0, 1e-6);
    EXPECT_GT(above.y, 0.01F);
    const glm::vec3 right = glm::cross(usual.target - usual.eye, usual.up);
    EXPECT_GT(device_position(camera, usual.target + 0.1F * right).x, 0.01F);
}

TEST(MakeCamera, TheFieldOfViewIsVerticalAndPixelsAreSquare) {
    const View view{.eye = {0, 0, 10}, .fov_y = glm::radians(90.0F), .near = 1, .far = 20};
    for (const glm::ivec2 size : {glm::ivec2{300, 300}, glm::ivec2{900, 300}, glm::ivec2{10, 50}}) {
        const Camera camera = make_camera(view, size, {});
        EXPECT_NEAR(device_position(camera, {0, 10, 0}).y, 1, 1e-5);
        const float half_width = 10 * static_cast<float>(size.x) / static_cast<float>(size.y);
        EXPECT_NEAR(device_position(camera, {half_width, 0, 0}).x, 1, 1e-5);
        EXPECT_NEAR(device_position(camera, {0, 0, 9}).z, -1, 1e-4);
        EXPECT_NEAR(device_position(camera, {0, 0, -10}).z, 1, 1e-4);
    }
}

TEST(MakeCamera, FittedPlanesHoldTheBounds) {
    test::Random random{31};
    for (int round = 0; round < 300; ++round) {
        const glm::vec3 middle = random.point(20);
        const glm::vec3 half = glm::abs(random.point(2));
        const Bounds bounds{.min = middle - half, .max = middle + half};
        const View view{.eye = middle + random.direction() * random.between(6, 500),
                        .target = middle,
                        .up = random.direction()};
        const Camera camera = make_camera(view, {640, 480}, bounds);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 p{(corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                              (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                              (corner & 4) != 0 ? bounds.max.z : bounds.min.z};
            const float depth = device_position(camera, p).z;
            EXPECT_GT(depth, -1);
            EXPECT_LT(depth, 1);
        }
    }
}

TEST(MakeCamera, FittedPlanesWorkInsideBeforeAndBesideTheBounds) {
    const Bounds point{.min = {1, 2, 3}, .max = {1, 2, 3}};
    for (const auto& [view, bounds] :
         {std::pair{View{.eye = {0.1F, 0, 0}, .target = {1, 0.5F, 0}}, unit_box}, // inside
          std::pair{View{.eye = {0, 0, 5}, .target = {0, 0, 9}}, unit_box},       // looking away
          std::pair{View{.eye = {1, 2, 8}, .target = {1, 2, 3}}, point},
          std::pair{View{.eye = {0, 0, 1}}, unit_box}}) { // on the border
        const Camera camera = make_camera(view, {64, 64}, bounds);
        const glm::mat4 matrix = camera.clip_from_world();
        for (int i = 0; i < 16; ++i) EXPECT_TRUE(std::isfinite(matrix[i / 4][i % 4]));
        EXPECT_NE(glm::determinant(matrix), 0);
    }
}

TEST(MakeCamera, GivenPlanesNeedNoBounds) {
    View view = usual;
    view.near = 0.5F;
    view.far = 50;
    EXPECT_NO_THROW(make_camera(view, {64, 64}, {}));
    view.far = 0;
    EXPECT_THROW(make_camera(view, {64, 64}, {}), UsageError);
    view = usual;
    view.far = 50;
    EXPECT_THROW(make_camera(view, {64, 64}, {}), UsageError);
}

TEST(MakeCamera, RefusesNumbersThatAreNotFinite) {
    for (const float bad : {not_a_number, infinity, -infinity}) {
        for (int axis = 0; axis < 3; ++axis) {
            View view = usual;
            view.eye[axis] = bad;
            EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError);
            view = usual;
            view.target[axis] = bad;
            EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError);
            view = usual;
            view.up[axis] = bad;
            EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError);
        }
        for (float View::*number : {&View::fov_y, &View::near, &View::far}) {
            View view = usual;
            view.*number = bad;
            EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError);
        }
    }
}

TEST(MakeCamera, RefusesWhatMakesNoSense) {
    for (const glm::ivec2 size : {glm::ivec2{0, 64}, glm::ivec2{64, 0}, glm::ivec2{-1, 64}}) {
        EXPECT_THROW(make_camera(usual, size, unit_box), UsageError);
    }
    for (const float fov : {0.0F, -0.5F, glm::pi<float>(), 4.0F}) {
        View view = usual;
        view.fov_y = fov;
        EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError) << fov;
    }
    View view = usual;
    view.target = view.eye;
    EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError);
    for (const float length : {1.0F, -1.0F, 1e-8F, 1e8F}) {
        view = usual;
        view.up = length * (view.target - view.eye);
        EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError) << length;
    }
    view.up = {0, 0, 0};
    EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError);
    view = usual;
    view.near = 5;
    view.far = 5;
    EXPECT_THROW(make_camera(view, {64, 64}, unit_box), UsageError);
}

TEST(MakeCamera, TheLengthOfUpDoesNotMatter) {
    const Camera expected = make_camera(usual, {64, 64}, unit_box);
    for (const float length : {1e-15F, 1e15F}) {
        View view = usual;
        view.up *= length;
        const Camera camera = make_camera(view, {64, 64}, unit_box);
        for (int i = 0; i < 16; ++i) {
            EXPECT_NEAR(camera.view[i / 4][i % 4], expected.view[i / 4][i % 4], 1e-5);
        }
    }
}

TEST(CameraEye, OfAPerspectiveIsTheEye) {
    test::Random random{32};
    for (int round = 0; round < 300; ++round) {
        const float distance = std::exp(random.between(-3, 6));
        const glm::vec3 target = random.point(1);
        const View view{.eye = target + distance * random.direction(),
                        .target = target,
                        .up = random.direction(),
                        .fov_y = random.between(0.1F, 2.5F)};
        const glm::vec4 eye =
            make_camera(view, {random.below(900) + 1, random.below(900) + 1}, unit_box).eye();
        EXPECT_EQ(eye.w, 1);
        EXPECT_LT(glm::distance(glm::vec3{eye}, view.eye), 1e-4F * (1 + distance));
    }
}

TEST(CameraEye, OfAnObliquePerspectiveIsTheEye) {
    const glm::vec3 eye{4, -2, 3};
    const Camera camera{.view = glm::lookAt(eye, glm::vec3{0}, glm::vec3{0, 0, 1}),
                        .projection = glm::frustum(-0.2F, 1.5F, 0.3F, 0.9F, 1.0F, 20.0F),
                        .size = {64, 64}};
    EXPECT_EQ(camera.eye().w, 1);
    EXPECT_LT(glm::distance(glm::vec3{camera.eye()}, eye), 1e-4F);
}

TEST(CameraEye, OfAParallelProjectionIsTheDirectionTowardsTheViewer) {
    test::Random random{33};
    for (int round = 0; round < 100; ++round) {
        const glm::vec3 back = random.direction();
        const glm::vec3 target = random.point(10);
        const Camera camera{
            .view = glm::lookAt(target + 5.0F * back, target, glm::vec3{0.1F, 0.7F, 0.7F}),
            .projection = glm::ortho(-3.0F, 1.0F, -2.0F, 2.0F, random.between(-5, 1), 20.0F),
            .size = {64, 64}};
        const glm::vec4 eye = camera.eye();
        EXPECT_EQ(eye.w, 0);
        EXPECT_LT(glm::distance(glm::normalize(glm::vec3{eye}), back), 1e-4F);
    }
}

/// A cabinet projection is common in technical drawing. It draws depth to the side and upwards.
TEST(CameraEye, OfAnObliqueParallelProjectionIsTheDirectionTowardsTheViewer) {
    glm::mat4 shear{1};
    shear[2] = {-0.35F, -0.35F, 1, 0};
    const Camera camera{.view = glm::translate(glm::mat4{1}, glm::vec3{0, 0, -5}),
                        .projection = glm::ortho(-3.0F, 3.0F, -3.0F, 3.0F, 0.1F, 20.0F) * shear,
                        .size = {64, 64}};
    const glm::vec4 eye = camera.eye();
    EXPECT_EQ(eye.w, 0);
    // Points along the direction towards the viewer fall on the same pixel.
    const glm::vec4 shift = camera.clip_from_world() * glm::vec4{glm::vec3{eye}, 0};
    EXPECT_NEAR(shift.x, 0, 1e-5);
    EXPECT_NEAR(shift.y, 0, 1e-5);
    EXPECT_LT(shift.z, 0);
}

constexpr std::array<glm::vec3, 6> axes{glm::vec3{1, 0, 0}, glm::vec3{-1, 0, 0},
                                        glm::vec3{0, 1, 0}, glm::vec3{0, -1, 0},
                                        glm::vec3{0, 0, 1}, glm::vec3{0, 0, -1}};

TEST(FramePoints, ShowsAllPointsCentredAndAsLargeAsTheyFit) {
    test::Random random{34};
    for (int round = 0; round < 400; ++round) {
        const glm::vec3 middle = random.point(round % 2 == 0 ? 0 : 50);
        const glm::vec3 half{random.between(0.1F, 2), random.between(0.1F, 2),
                             random.between(0.1F, 2)};
        std::vector<glm::vec3> points;
        const std::uint32_t count = 8 + random.below(60);
        for (std::uint32_t i = 0; i < count; ++i) {
            points.push_back(middle + half * random.point(1));
        }
        const glm::ivec2 size{50 + random.below(1500), 50 + random.below(1500)};
        const View view = frame_points(points, size, axes[static_cast<std::size_t>(round) % 6],
                                       random.between(0.1F, 1.2F));
        const Bounds outline = outline_of(make_camera(view, size, box_of(points)), points);
        constexpr float tolerance = 2e-3F;
        EXPECT_GE(outline.min.z, -1);
        EXPECT_LE(outline.max.z, 1);
        float widest = 0;
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(outline.min[axis] + outline.max[axis], 0, tolerance) << "not centred";
            EXPECT_LE(outline.max[axis], frame_margin + tolerance);
            widest = std::max(widest, outline.max[axis]);
        }
        EXPECT_NEAR(widest, frame_margin, tolerance) << "smaller than it could be";
    }
}

TEST(FramePoints, LooksFromTheFrontTheRightAndAbove) {
    const std::vector<glm::vec3> points = test::cube().positions;
    const View y_up = frame_points(points, {400, 300});
    EXPECT_EQ(y_up.up, glm::vec3(0, 1, 0));
    EXPECT_GT(y_up.eye.x, 1);
    EXPECT_GT(y_up.eye.y, 1);
    EXPECT_GT(y_up.eye.z, 1);
    const View z_up = frame_points(points, {400, 300}, {0, 0, 1}, 0.5F);
    EXPECT_EQ(z_up.up, glm::vec3(0, 0, 1));
    EXPECT_EQ(z_up.fov_y, 0.5F);
    EXPECT_GT(z_up.eye.x, 1);
    EXPECT_LT(z_up.eye.y, -1);
    EXPECT_GT(z_up.eye.z, 1);
    EXPECT_GT(z_up.eye.z, std::abs(z_up.target.z));
}

TEST(FramePoints, TakesPointsWithoutExtent) {
    for (const std::vector<glm::vec3>& points :
         {std::vector<glm::vec3>{{3, 4, 5}}, {{3, 4, 5}, {3, 4, 5}}, {{0, 0, 0}, {0, 2, 0}}}) {
        const View view = frame_points(points, {200, 100});
        const Bounds outline = outline_of(make_camera(view, {200, 100}, box_of(points)), points);
        EXPECT_NEAR(outline.min.x + outline.max.x, 0, 1e-3);
        EXPECT_NEAR(outline.min.y + outline.max.y, 0, 1e-3);
        EXPECT_LE(outline.max.y, frame_margin + 1e-3F);
    }
    EXPECT_THROW(frame_points({}, {200, 100}), UsageError);
}

/// A rod along the line of sight: the frame alone would let the eye touch its tip.
TEST(FramePoints, StaysAwayFromATipThatPointsAtTheEye) {
    const glm::vec3 along = glm::normalize(glm::vec3{0.75F, 0.6F, 1});
    for (const float thickness : {0.0F, 0.01F, 0.1F}) {
        std::vector<glm::vec3> points{2.0F * along, -2.0F * along};
        for (const glm::vec3& axis : axes) points.push_back(-2.0F * along + thickness * axis);
        const View view = frame_points(points, {300, 300});
        const glm::vec3 sight = glm::normalize(view.target - view.eye);
        EXPECT_GT(glm::dot(points[0] - view.eye, sight), 0.01F) << thickness;
        const Bounds outline = outline_of(make_camera(view, {300, 300}, box_of(points)), points);
        EXPECT_GT(outline.min.z, -1) << "cut off by the near plane";
    }
}

TEST(BoundsOf, HoldPositionsThatTrianglesAndPolylinesUse) {
    Mesh mesh;
    mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 4}, {-9, 0, 0}};
    mesh.triangles = {{1, 2, 3}};
    mesh.polylines = {{1, 4}};
    EXPECT_EQ(bounds_of(mesh).min, glm::vec3(0, 0, 0));
    EXPECT_EQ(bounds_of(mesh).max, glm::vec3(1, 1, 4));
    EXPECT_GT(bounds_of(Mesh{}).min.x, bounds_of(Mesh{}).max.x);
    mesh.polylines.push_back({6});
    EXPECT_THROW(bounds_of(mesh), UsageError);
}

/// The place of a point in the picture: pixels from the lower left corner.
glm::vec2 pixel(const Camera& camera, glm::vec3 point) {
    return (glm::vec2{device_position(camera, point)} + 1.0F) * 0.5F * glm::vec2{camera.size};
}

TEST(Orthographic, LengthsDoNotDependOnDistance) {
    View view = usual;
    view.projection = Projection::orthographic;
    const Camera camera = make_camera(view, {800, 400}, unit_box);
    const glm::vec3 edge{0.3F, 0.1F, -0.2F};
    const glm::vec2 near = pixel(camera, view.eye * 0.2F + edge) - pixel(camera, view.eye * 0.2F);
    const glm::vec2 far = pixel(camera, edge - view.eye) - pixel(camera, -view.eye);
    EXPECT_NEAR(near.x, far.x, 1e-3);
    EXPECT_NEAR(near.y, far.y, 1e-3);
    EXPECT_EQ(camera.eye().w, 0);
    EXPECT_LT(glm::distance(glm::vec3{camera.eye()}, glm::normalize(view.eye)), 1e-5F);
}

TEST(Orthographic, ShowsAsMuchAsPerspectiveDoesAtTheTarget) {
    View view = usual;
    const glm::vec3 above = glm::cross(glm::normalize(glm::cross(-view.eye, view.up)),
                                       glm::normalize(-view.eye)); // upwards in the picture
    const float half = 0.5F * shown_height(view);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        view.projection = projection;
        const Camera camera = make_camera(view, {800, 400}, unit_box);
        EXPECT_NEAR(pixel(camera, half * above).y, 400, 1e-2) << name_of(projection);
    }
    EXPECT_NEAR(shown_height(with_shown_height(view, 12.5F)), 12.5F, 1e-5F);
    EXPECT_THROW(with_shown_height(view, 0), UsageError);
}

TEST(Orthographic, PlanesHoldWhatLiesBehindTheEye) {
    View view{.eye = {0, 0, 0.1F}, .target = {0, 0, 0}, .projection = Projection::orthographic};
    const Camera camera = make_camera(view, {100, 100}, unit_box);
    for (const float z : {-1.0F, 1.0F}) {
        const float depth = device_position(camera, {0, 0, z}).z;
        EXPECT_GT(depth, -1) << z;
        EXPECT_LT(depth, 1) << z;
    }
}

TEST(Orthographic, FramedPointsJustFit) {
    const std::vector<glm::vec3> points{{5, 1, 0}, {9, 1, 0}, {5, 2, 0}, {9, 2, 7}};
    for (const char* name : {"front", "top", "isometric", "-130,15"}) {
        const View view = frame_points_from(view_direction(name, {0, 1, 0}), points, {300, 200},
                                            0.7F, Projection::orthographic);
        const Bounds outline = outline_of(make_camera(view, {300, 200}, box_of(points)), points);
        EXPECT_NEAR(outline.min.x, -outline.max.x, 1e-4F) << name;
        EXPECT_NEAR(outline.min.y, -outline.max.y, 1e-4F) << name;
        EXPECT_NEAR(std::max(outline.max.x, outline.max.y), frame_margin, 1e-4F) << name;
    }
}

TEST(Orthographic, TheEdgesOfAnIsometricCubeAreEqual) {
    const View view = frame_points_from(view_direction("isometric", {0, 0, 1}),
                                        std::array{unit_box.min, unit_box.max}, {2000, 2000}, 0.7F,
                                        Projection::orthographic);
    const Camera camera = make_camera(view, {2000, 2000}, unit_box);
    const auto length = [&](glm::vec3 edge) {
        return glm::distance(pixel(camera, unit_box.min),
                             pixel(camera, unit_box.min + 2.0F * edge));
    };
    EXPECT_GT(length({1, 0, 0}), 100);
    EXPECT_NEAR(length({0, 1, 0}), length({1, 0, 0}), 0.01);
    EXPECT_NEAR(length({0, 0, 1}), length({1, 0, 0}), 0.01);
}

TEST(Orthographic, ADimetricCubeIsHalfAsDeepAsWide) {
    const View view = frame_points_from(view_direction("dimetric", {0, 1, 0}),
                                        std::array{unit_box.min, unit_box.max}, {2000, 2000}, 0.7F,
                                        Projection::orthographic);
    const Camera camera = make_camera(view, {2000, 2000}, unit_box);
    const auto length = [&](glm::vec3 edge) {
        return glm::distance(pixel(camera, {0, 0, 0}), pixel(camera, edge));
    };
    EXPECT_NEAR(length({0, 1, 0}), length({1, 0, 0}), 0.01);
    EXPECT_NEAR(length({0, 0, 1}), 0.5F * length({1, 0, 0}), 0.01);
}

TEST(ViewDirection, SidesLieAsADraughtsmanPutsThem) {
    const auto expect = [](const char* name, glm::vec3 model_up, glm::vec3 toward, glm::vec3 up) {
        const ViewDirection direction = view_direction(name, model_up);
        EXPECT_LT(glm::distance(direction.toward_eye, toward), 1e-6F) << name;
        EXPECT_LT(glm::distance(direction.up, up), 1e-6F) << name;
    };
    const glm::vec3 y{0, 1, 0}, z{0, 0, 1};
    expect("front", y, {0, 0, 1}, y);
    expect("back", y, {0, 0, -1}, y);
    expect("left", y, {-1, 0, 0}, y);
    expect("right", y, {1, 0, 0}, y);
    expect("top", y, {0, 1, 0}, {0, 0, -1}); // the front is at the bottom of the picture
    expect("bottom", y, {0, -1, 0}, {0, 0, 1});
    expect("front", z, {0, -1, 0}, z);
    expect("right", z, {1, 0, 0}, z);
    expect("top", z, {0, 0, 1}, {0, 1, 0});
    expect("90,0", y, {1, 0, 0}, y);
    expect("0,30", y, {0, 0.5F, std::sqrt(0.75F)}, y);
}

TEST(ViewDirection, RefusesUnknownDirections) {
    for (const char* name : {"", "fron", "30", "30,", "30,91", "nan,0", "30,20,1", "30;20"}) {
        EXPECT_THROW(view_direction(name, {0, 1, 0}), UsageError) << name;
    }
    EXPECT_THROW(parse_projection("parallel"), UsageError);
}

} // namespace
} // namespace lineatlas
