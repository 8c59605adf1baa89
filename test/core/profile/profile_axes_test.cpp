// SPDX-License-Identifier: BSD-3-Clause
#include "profile_helpers.h"

namespace wheel_rail_contact::core
{
// Files whose origin is not where the profile frame has it, and the options that move and turn points.
namespace
{
using Origin = ProfileReading::Origin;

constexpr double rounding = 1e-12;  ///< of 12 digits [m]
constexpr double of_top = 1e-7;     ///< by which the highest of the points may be below the crown [m]

class OriginTest : public testing::Test
{
 protected:
  DescribedProfile read(const std::vector<Point>& points, ProfileKind kind, const ProfileReading& reading = {}) const
  {
    return describedProfile(folder_.write("profile.csv", "y_m,z_m\n" + lines(points, ",")), kind, reading);
  }

  std::string refusal(const std::vector<Point>& points, ProfileKind kind, const ProfileReading& reading = {}) const
  {
    return refusalOf<FileError>([&] { read(points, kind, reading); });
  }

  static ProfileReading with(Origin origin)
  {
    ProfileReading reading;
    reading.origin = origin;
    return reading;
  }

  const std::vector<Point> rail_ = pointsOf(rail60E1()), wheel_ = pointsOf(s1002Wheel());
  Folder folder_;
};

/// Outline of a whole rail, closed, with the head of 60E1; from the foot's corner on the gauge side.
std::vector<Point> wholeRail()
{
  std::vector<Point> outline{{-0.075, -0.172}, {-0.075, -0.160}, {-0.009, -0.140}, {-0.009, -0.050}};
  const std::vector<Point> head = pointsOf(rail60E1());
  outline.insert(outline.end(), head.begin(), head.end());
  outline.insert(outline.end(), {{0.009, -0.050}, {0.009, -0.140}, {0.075, -0.160}, {0.075, -0.172}, {-0.075, -0.172}});
  return outline;
}

TEST_F(OriginTest, OfARailIsFoundFromItsShape)
{
  const std::pair<double, double> places[] = {{0, 0.172}, {0, 0.081}, {0.0365, 0}, {-0.0365, -0.05}, {0.7535, 0.1}};
  for (const auto& [y, z] : places)
  {
    const DescribedProfile described = read(moved(rail_, y, z), ProfileKind::rail);
    EXPECT_LT(deviation(described.profile, rail_), of_top);
    EXPECT_NEAR(described.report.moved_y, std::abs(y) > 0.015 ? -y : 0, 1e-9);
    EXPECT_NEAR(described.report.moved_z, z == 0 ? 0 : -z, of_top);
    EXPECT_TRUE(contains(described.report.text, "moved by"));
  }
}

TEST_F(OriginTest, OfAWornRailStaysOnTheCrownOfTheNewOne)
{
  for (const double wear : {0.0, 0.006, 0.018})
  {
    const DescribedProfile described = read(moved(rail_, 0.002, -wear), ProfileKind::rail);
    EXPECT_LT(deviation(described.profile, moved(rail_, 0.002, -wear)), rounding);
    EXPECT_EQ(described.report.moved_z, 0);
  }
}

TEST_F(OriginTest, OfARailCanBeStated)
{
  EXPECT_LT(deviation(read(moved(rail_, 0.010, 0), ProfileKind::rail, with(Origin::gauge_corner)).profile, rail_),
            of_top);
  // Near the axis, y would be kept without the option.
  EXPECT_LT(deviation(read(moved(rail_, 0.010, 0.172), ProfileKind::rail, with(Origin::foot)).profile,
                      moved(rail_, 0.010, 0)),
            1e-6);
  EXPECT_LT(deviation(read(moved(rail_, 0.010, 0.004), ProfileKind::rail, with(Origin::crown)).profile,
                      moved(rail_, 0.010, 0.004)),
            rounding);
  const std::vector<Point> half(rail_.begin(), rail_.begin() + static_cast<long>(rail_.size() * 6 / 10));
  EXPECT_TRUE(contains(refusal(moved(half, 0.02, 0), ProfileKind::rail, with(Origin::gauge_corner)),
                       "one side of the head is missing"));
}

TEST_F(OriginTest, OfASectionIsNotMoved)
{
  const DescribedProfile described = read(moved(rail_, 0.05, -0.03), ProfileKind::rail_section);
  EXPECT_LT(deviation(described.profile, moved(rail_, 0.05, -0.03)), rounding);
}

TEST_F(OriginTest, OfAWheelIsItsRunningCircle)
{
  EXPECT_TRUE(contains(refusal(moved(wheel_, 0.070, 0), ProfileKind::wheel), "give origin: flange_back"));
  EXPECT_TRUE(
      contains(refusal(moved(wheel_, 0.75, 0), ProfileKind::wheel), "give shift: {y: -0.75}, half the distance"));
  const DescribedProfile described = read(moved(wheel_, 0.070, 0.012), ProfileKind::wheel, with(Origin::flange_back));
  EXPECT_LT(deviation(described.profile, wheel_), of_top) << "the height follows from the running circle";
  EXPECT_TRUE(contains(refusal(moved(wheel_, 0, 0.012), ProfileKind::wheel), "a shift of z moves it"));
  ProfileReading reading;
  reading.shift_z = -0.012;
  EXPECT_LT(deviation(read(moved(wheel_, 0, 0.012), ProfileKind::wheel, reading).profile, wheel_), 1e-9);
}

TEST_F(OriginTest, OfASimpackWheelMayBeItsFlangeBack)
{
  const auto listed = changed(wheel_, [](const Point& p) { return Point{1e3 * p.y + 70, -1e3 * p.z + 28}; });
  const std::string path = folder_.write(
      "wheel.prw",
      "header.begin\n version = 1\n type = 1\nheader.end\nspline.begin\n units.len.f = 1000\n point.begin\n" +
          lines(listed, " ") + " point.end\nspline.end\n");
  EXPECT_LT(deviation(readProfile(path, ProfileKind::wheel, with(Origin::flange_back)), wheel_), of_top);
  EXPECT_TRUE(contains(refusalOf<FileError>([&] { readProfile(path, ProfileKind::wheel); }), "origin: flange_back"));
}

TEST_F(OriginTest, ShiftMovesAWheelFromItsFlangeBackToo)
{
  ProfileReading reading = with(Origin::flange_back);
  reading.shift_z = 0.002;
  const DescribedProfile described = read(moved(wheel_, 0.070, 0.012), ProfileKind::wheel, reading);
  EXPECT_LT(deviation(described.profile, moved(wheel_, 0, 0.002)), of_top);
  EXPECT_NEAR(described.report.moved_z, -0.010, of_top);
}

TEST_F(OriginTest, OfAnotherBodyOrPlaceIsRefused)
{
  EXPECT_TRUE(contains(refusal(wheel_, ProfileKind::wheel, with(Origin::crown)), "belongs to a rail"));
  EXPECT_TRUE(contains(refusal(rail_, ProfileKind::rail, with(Origin::flange_back)), "belongs to a wheel"));
  EXPECT_TRUE(contains(refusal(rail_, ProfileKind::rail_section, with(Origin::foot)), "keeps its coordinates"));
  for (const double y : {-0.025, -0.02, 0.015, 0.02, 0.03})
  {
    EXPECT_TRUE(contains(refusal(moved(wheel_, y, 0), ProfileKind::wheel), "running circle")) << y;
  }
  // The flange of a wheel with z reversed is a small head; its tread lies deep below it.
  for (const double sign : {-1.0, 1.0})
  {
    EXPECT_TRUE(contains(refusal(scaled(wheel_, sign, -1), ProfileKind::rail), "not a rail"));
  }
}

TEST_F(OriginTest, ShiftIsFollowedByRotationAndMirror)
{
  const double angle = 0.025, c = std::cos(angle), s = std::sin(angle);
  ProfileReading reading;
  reading.shift_y = 0.003;
  reading.shift_z = 0.001;
  reading.rotate = angle;
  reading.mirror = true;
  const std::vector<Point> expected = changed(moved(rail_, 0.003, 0.001),
                                              [=](const Point& p) {
                                                return Point{-(c * p.y - s * p.z), s * p.y + c * p.z};
                                              });
  std::vector<Point> in_order(expected.rbegin(), expected.rend());
  EXPECT_LT(deviation(read(rail_, ProfileKind::rail, reading).profile, in_order), 1e-9);
}

TEST_F(OriginTest, HeadOfAWholeRailIsUsed)
{
  const std::vector<Point> outline = wholeRail();
  for (const std::size_t first : {std::size_t{0}, std::size_t{40}, std::size_t{200}, outline.size() - 3})
  {
    std::vector<Point> turned = outline;
    std::rotate(turned.begin(), turned.begin() + static_cast<long>(first), turned.end());
    const DescribedProfile described = read(moved(turned, 0, 0.081), ProfileKind::rail);
    EXPECT_LT(deviation(described.profile, rail_), of_top) << "begins at point " << first;
    EXPECT_GT(described.report.omitted, 0U);
  }
}

TEST_F(OriginTest, HeadWithItsUndersideIsUsed)
{
  std::vector<Point> points = rail_;
  const Point left = points.front(), right = points.back();
  for (int i = 1; i <= 20; ++i)  // 1:3, up to 20 mm towards the web
  {
    points.insert(points.begin(), {left.y + 1 * mm * i, left.z - 0.33 * mm * i});
    points.push_back({right.y - 1 * mm * i, right.z - 0.33 * mm * i});
  }
  EXPECT_LT(deviation(read(points, ProfileKind::rail).profile, rail_), of_top);
}

/// A head of 60E1, and on its gauge side a groove 40 mm wide and 37 mm deep, and a lip.
/// @param lip  half its width [m]
/// @param rise  of its top above that of the head [m]
std::vector<Point> groovedRail(const std::vector<Point>& head, double lip, double rise)
{
  std::vector<Point> points;
  const double floor = head.front().z, middle = head.front().y - 0.040 - lip;
  for (int i = -50; i <= 50; ++i)
  {
    const double share = i / 50.0;
    points.push_back({middle + lip * share, rise + (floor - rise) * std::pow(share, 4)});
  }
  for (int i = 1; i < 80; ++i)
  {
    points.push_back({middle + lip + 0.0005 * i, floor});
  }
  points.insert(points.end(), head.begin(), head.end());
  return points;
}

TEST_F(OriginTest, LipOfAGroovedRailIsNotTakenForItsHead)
{
  for (const double rise : {0.0, 0.003, -0.016})
  {
    const DescribedProfile rail = read(groovedRail(rail_, 0.011, rise), ProfileKind::rail);
    EXPECT_LT(deviation(rail.profile, rail_), of_top) << rise;
    EXPECT_TRUE(contains(rail.report.text, "omitted what lies beside the head"));
  }
  EXPECT_TRUE(contains(refusal(groovedRail(rail_, 0.045, 0), ProfileKind::rail), "rail/profile/parts"));
  EXPECT_TRUE(contains(refusal(scaled(groovedRail(rail_, 0.011, 0), -1, 1), ProfileKind::rail), "or reverse y"));
}

TEST_F(OriginTest, InclinationOfARailIsReported)
{
  std::vector<Point> points;
  for (const Point& p : rail_)  // down to 14.5 mm: the sides of the head do not show it
  {
    if (p.z > -14.5 * mm)
    {
      points.push_back({p.y * std::cos(0.025) - p.z * std::sin(0.025), p.z * std::cos(0.025) + p.y * std::sin(0.025)});
    }
  }
  for (const bool reversed : {false, true})
  {
    const ProfileReport report = read(scaled(points, reversed ? -1 : 1, 1), ProfileKind::rail).report;
    ASSERT_TRUE(report.inclination);
    EXPECT_NEAR(*report.inclination, reversed ? -0.025 : 0.025, 1e-4);  // the points are 0.25 mm apart
    EXPECT_TRUE(contains(report.text, reversed ? "looks inclined by 1:40 to the field side"
                                               : "looks inclined by 1:40 towards the track centre"));
  }
}

// The end of a rim rises by 20 mm. Turned by half a turn, it looks like a flange, and the flange like nothing of a
// wheel.
TEST_F(OriginTest, RimIsNotTakenForAFlange)
{
  std::vector<Point> whole = wheel_;
  for (int i = 1; i <= 20; ++i)
  {
    whole.push_back({0.060 + 0.0002 * i, whole.back().z + 0.001});
  }
  EXPECT_LT(deviation(read(whole, ProfileKind::wheel).profile, whole), rounding);
  const auto turned = scaled(whole, -1, -1);
  EXPECT_TRUE(contains(refusal(turned, ProfileKind::wheel),
                       "both axes are reversed; the points are a profile by y: inward, z: down"));
  EXPECT_TRUE(
      contains(refusal(scaled(whole, -1, 1), ProfileKind::wheel), "the points are a profile by y: inward, z: up"));
  // Without the flange back: the curve ends at the tip.
  std::vector<Point> to_tip;
  std::copy_if(turned.begin(), turned.end(), std::back_inserter(to_tip), [](const Point& p) { return p.y < 0.0545; });
  EXPECT_TRUE(contains(refusal(to_tip, ProfileKind::wheel), "both axes are reversed"));
}

TEST_F(OriginTest, OptionsOutOfRangeAreRefused)
{
  const std::function<void(ProfileReading&)> mistakes[] = {
      [](ProfileReading& reading) { reading.unit = 0; }, [](ProfileReading& reading) { reading.shift_y = 1.5; },
      [](ProfileReading& reading) { reading.rotate = NAN; }, [](ProfileReading& reading) { reading.smoothing = 2e-4; }};
  for (const auto& make : mistakes)
  {
    ProfileReading reading;
    make(reading);
    EXPECT_THROW(read(rail_, ProfileKind::rail, reading), std::invalid_argument);
  }
}

const ProfileReading mirror = mirrored();

/// Points of a rail head with more wear on its gauge side [m].
std::vector<Point> wornRail()
{
  return changed(pointsOf(rail60E1()), [](const Point& p) { return Point{p.y, p.z * (p.y < 0 ? 1.02 : 1)}; });
}

/// Expects the curves to be equal in every bit.
void expectSameCurve(const Profile& a, const Profile& b)
{
  ASSERT_EQ(a.length(), b.length());
  for (int i = 0; i <= 500; ++i)
  {
    const CurvePoint p = a.at(a.length() * i / 500), q = b.at(a.length() * i / 500);
    EXPECT_EQ(p.y, q.y);
    EXPECT_EQ(p.z, q.z);
    EXPECT_EQ(p.dy, q.dy);
    EXPECT_EQ(p.ddz, q.ddz);
  }
}

/// Text of a file in a format, from points in the profile frame [m].
struct Format
{
  const char* extension;
  ProfileKind kind;
  std::string (*text)(const std::vector<Point>& points);
};

std::string simpack(const std::vector<Point>& points, const char* type)
{
  return std::string("header.begin\n version = 1\n type = ") + type +
         "\nheader.end\nspline.begin\n approx.smooth = 0\n units.len.f = 1000\n point.begin\n" +
         lines(scaled(points, 1e3, -1e3), " ") + " point.end\nspline.end\n";
}

const Format formats[] = {
    {"csv", ProfileKind::wheel, csv},
    {"csv", ProfileKind::rail, csv},
    {"prw", ProfileKind::wheel, [](const std::vector<Point>& points) { return simpack(points, "1"); }},
    {"prr", ProfileKind::rail, [](const std::vector<Point>& points) { return simpack(points, "0"); }},
    {"whl", ProfileKind::wheel,
     [](const std::vector<Point>& points) { return lines(moved(scaled(points, 1e3, -1e3), 70, 0), " "); }},
    {"ban", ProfileKind::rail, [](const std::vector<Point>& points) { return lines(scaled(points, -1e3, 1e3), " "); }}};

// The sign of a number in the file does not affect its rounding, except that of a MiniProf wheel, whose X is counted
// from the flange back: 70 mm + y and 70 mm - y are written with twelve digits, to 1e-13 m.
TEST(MirroredProfile, IsTheProfileWrittenWithYNegated)
{
  const Folder folder;
  for (const Format& format : formats)
  {
    SCOPED_TRACE(format.extension);
    const std::vector<Point> points = format.kind == ProfileKind::wheel ? pointsOf(s1002Wheel()) : wornRail();
    const std::string name = std::string("given.") + format.extension;
    const Profile given = readProfile(folder.write(name, format.text(points)), format.kind);
    const std::string negated_name = std::string("negated.") + format.extension;
    const std::string path = folder.write(negated_name, format.text(scaled(points, -1, 1)));
    const Profile mirrored = readProfile(path, format.kind, mirror);
    EXPECT_EQ(mirrored.name(), negated_name);
    if (std::string(format.extension) == "whl")
    {
      EXPECT_NEAR(mirrored.length(), given.length(), 1e-9);
      EXPECT_LT(deviation(mirrored, pointsOf(given)), 1e-9) << "1e-13 m over 0.25 mm, smoothed";
    }
    else
    {
      expectSameCurve(mirrored, given);
    }
  }
}

TEST(MirroredProfile, OfAWheelOfTheRightOrientationIsNotAWheel)
{
  const Folder folder;
  const std::vector<Point> wheel = pointsOf(s1002Wheel());
  const std::string given = folder.write("given.csv", csv(wheel));
  const std::string negated_file = folder.write("negated.csv", csv(scaled(wheel, -1, 1)));
  EXPECT_THROW(readProfile(given, ProfileKind::wheel, mirror), FileError);
  EXPECT_THROW(readProfile(negated_file, ProfileKind::wheel), FileError);
  EXPECT_NO_THROW(loadProfile(negated_file, ProfileKind::wheel, mirror));
}

TEST(MirroredProfile, IsSmoothedForTheSameNoise)
{
  const Folder folder;
  const std::vector<Point> rail = wornRail();
  const Profile given = readProfile(folder.write("given.csv", csv(rail)), ProfileKind::rail, {5e-6});
  const std::string path = folder.write("negated.csv", csv(scaled(rail, -1, 1)));
  expectSameCurve(readProfile(path, ProfileKind::rail, mirrored(5e-6)), given);
}
}  // namespace
}  // namespace wheel_rail_contact::core
