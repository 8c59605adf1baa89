// SPDX-License-Identifier: BSD-3-Clause
#include "wheel_rail_contact/core/profile_reader.h"

#include "../../seeded.h"
#include "core/profile/curve/spline.h"
#include "profile_helpers.h"

namespace wheel_rail_contact::core
{
namespace
{
/// Expects a FileError with this line and a reason that contains `reason`.
void expectRejected(const std::string& path, ProfileKind kind, std::size_t line, const std::string& reason)
{
  SCOPED_TRACE(path + ", expected error: " + reason);
  const auto error = thrownBy<FileError>([&] { readProfile(path, kind); });
  EXPECT_EQ(error.file(), path);
  EXPECT_EQ(error.line(), line) << error.what();
  EXPECT_TRUE(contains(error.reason(), reason));
  EXPECT_EQ(error.what(), path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + error.reason());
}

/// The same for a file with this text.
void expectTextRejected(const std::string& text, std::size_t line, const std::string& reason,
                        ProfileKind kind = ProfileKind::rail, const std::string& name = "bad.csv")
{
  const Folder folder;
  expectRejected(folder.write(name, text), kind, line, reason);
}

/// The points in a random order that is the same with every standard library. The order of std::shuffle is not.
std::vector<Point> shuffled(std::vector<Point> points, Seeded& random)
{
  for (std::size_t i = points.size() - 1; i > 0; --i)
  {
    std::swap(points[i], points[random() % (i + 1)]);
  }
  return points;
}

TEST(LoadProfile, ContentDeterminesTheFileFormat)
{
  const Folder folder;
  const std::string table = csv(pointsOf(rail60E1()));
  for (const char* name : {"head.CSV", "head.dat", "head", "head.ban", "head.prr"})
  {
    EXPECT_EQ(loadProfile(folder.write(name, table), ProfileKind::rail).name(), name);
    EXPECT_EQ(describedProfile(folder.path(name), ProfileKind::rail).report.format, "table");
  }
  EXPECT_TRUE(contains(refusalOf<FileError>([] { loadProfile("S1003", ProfileKind::wheel); }),
                       "neither the name of a standard profile"));
  expectRejected(folder.path("missing.csv"), ProfileKind::rail, 0, "no such file");
  const auto cut = thrownBy<FileError>([] { readProfile({"a\0b", 3}, ProfileKind::rail); });
  EXPECT_STREQ(cut.what(), "a?b: no such file");
}

TEST(TableProfile, TitlesDetermineTheUnit)
{
  const Folder folder;
  const std::vector<Point> points = pointsOf(s1002Wheel());
  const std::vector<Point> millimetres = scaled(points, 1e3, 1e3);
  const std::vector<Point> reversed(points.rbegin(), points.rend());
  const std::string files[] = {
      folder.write("metres.csv", "y_m,z_m\n" + lines(points, ",")),
      folder.write("spaces.csv", "\xEF\xBB\xBF y_m , z_m \r\n\r\n# remark\r\n" + lines(points, " , ")),
      folder.write("millimetres.csv", "# y_mm,z_mm (worn wheel)\n" + lines(millimetres, ",")),
      folder.write("reversed.csv", "y_m,z_m\n" + lines(reversed, ","))};
  for (const std::string& file : files)
  {
    const Profile wheel = readProfile(file, ProfileKind::wheel);
    EXPECT_LT(wheel.at(0.0).y, wheel.at(wheel.length()).y) << file;
    EXPECT_LT(deviation(wheel, points), 1e-12) << file;
  }
}

TEST(TableProfile, TwoNumbersInOneUnitAreRequired)
{
  const std::string points = lines(pointsOf(rail60E1()), ",");
  expectTextRejected("y,z\n" + points, 0, "does not state its unit");
  expectTextRejected("y_mm,z_m\n" + points, 1, "must be the same");
  expectTextRejected("y [furlong],z [furlong]\n" + points, 1, "unit 'furlong'");
  expectTextRejected("a_mm,b_mm\n" + points, 1, "nor titles of columns y and z");
  expectTextRejected("y_m,z_m\n" + points + "0.1\n",
                     2 + static_cast<std::size_t>(std::count(points.begin(), points.end(), '\n')),
                     "number of columns is 1");
  expectTextRejected("y_m,z_m\n0,0,0\n", 2, "number of columns is 3");
  for (const char* word : {"nan", "inf", "1e999", "0x10", ""})
  {
    expectTextRejected("y_m,z_m\n0,0\n0," + std::string(word) + "\n", 3,
                       "'" + std::string(word) + "' is not a finite number");
  }
  expectTextRejected("y_m,z_m\n0,0\n0;0\n", 3, "number of columns is 1");
}

TEST(ProfileFiles, BinaryEmptyAndOversizedFilesAreRejected)
{
  const Folder folder;
  expectTextRejected("", 0, "is empty");
  expectTextRejected(" \r\n\t\n", 0, "is empty");
  expectTextRejected(std::string("y_m,z_m\n0,0\0", 12), 0, "binary");
  expectTextRejected(
      "\x7F"
      "ELF",
      0, "binary");
  expectTextRejected(std::string((4U << 20U) + 1U, '#'), 0, "larger than 4 MiB");
  expectTextRejected("y_m,z_m\n" + std::string(2000, '1'), 2, "line has more than");
  std::string many = "y_m,z_m\n";
  for (int i = 0; i < 200001; ++i)
  {
    many += "0,0\n";
  }
  expectTextRejected(many, 200002, "more than 200000 points");
  expectRejected(folder.path("."), ProfileKind::rail, 0, "no such file");
  std::filesystem::create_directories(folder.path("folder.csv"));
  expectRejected(folder.path("folder.csv"), ProfileKind::rail, 0, "no such file");
}

TEST(ProfileFiles, ImplausibleProfilesAreRejected)
{
  const auto rejected = [&](const std::vector<Point>& points, std::size_t line, const std::string& reason,
                            ProfileKind kind = ProfileKind::rail)
  { expectTextRejected(csv(points), line, reason, kind); };
  const std::vector<Point> rail = pointsOf(rail60E1());
  const std::vector<Point> wheel = pointsOf(s1002Wheel());

  rejected({rail.begin(), rail.begin() + 9}, 0, "number of points is 9");
  rejected(scaled(rail, 1e3, 1e3), 0, "wrong unit");
  rejected(scaled(rail, 1e-3, 1e-3), 0, "wrong unit");
  rejected(scaled(rail, 1, 5), 0, "high");
  rejected(std::vector<Point>(50, Point{0.0, 0.0}), 0, "wide");

  // Wrong kind, wrong axes, wrong origin.
  rejected(wheel, 0, "highest point is at an end");
  rejected(rail, 0, "not a wheel", ProfileKind::wheel);
  rejected(scaled(rail, 1, -1), 0, "z does not point up");
  rejected(scaled(wheel, -1, 1), 0, "an axis is reversed; the points are a profile by y: inward, z: up",
           ProfileKind::wheel);
  rejected(scaled(wheel, 1, -1), 0, "not a wheel", ProfileKind::wheel);
  rejected(scaled(wheel, -1, -1), 0, "both axes are reversed", ProfileKind::wheel);
  rejected(moved(wheel, 0.07, 0), 0, "origin", ProfileKind::wheel);

  // Order along the curve.
  std::vector<Point> points = rail;
  std::swap(points[100], points[110]);
  rejected(points, 103, "run back");
  Seeded random(10);
  rejected(shuffled(rail, random), 4, "run back");
  points = rail;
  points.insert(points.end(), rail.rbegin(), rail.rend());
  rejected(points, rail.size() + 6, "run back");
  points = rail;
  points.erase(points.begin() + 100, points.begin() + 250);
  rejected(points, 102, "gap of");
  std::vector<Point> circle;
  for (int i = 0; i < 200; ++i)
  {
    circle.push_back({0.05 * std::sin(0.0314 * i), 0.05 * std::cos(0.0314 * i) - 0.05});
  }
  rejected(circle, 0, "closed outline");
}

TEST(ProfileFiles, CoincidentPointsAreMergedAndTheEndsAreKept)
{
  const Folder folder;
  const std::vector<Point> rail = pointsOf(rail60E1());
  std::vector<Point> points;
  for (const Point& p : rail)
  {
    points.insert(points.end(), {p, p, {p.y + 1e-9, p.z}});
  }
  const Profile read = readProfile(folder.write("double.csv", csv(points)), ProfileKind::rail);
  EXPECT_EQ(read.discontinuities().size(), rail.size());
  EXPECT_LT(deviation(read, rail), 2e-9);
  EXPECT_NEAR(read.at(0.0).y, points.front().y, 1e-12);
  EXPECT_NEAR(read.at(read.length()).y, points.back().y, 1e-12);
}

TEST(ProfileFiles, PointsAreSmoothedForAGivenNoise)
{
  const Folder folder;
  const std::string path = folder.write("head.csv", csv(pointsOf(rail60E1())));
  const Profile through = readProfile(path, ProfileKind::rail);
  const Profile near = readProfile(path, ProfileKind::rail, {5e-6});
  EXPECT_LT(deviation(through, pointsOf(rail60E1())), 1e-12);
  EXPECT_GT(deviation(near, pointsOf(rail60E1())), 5e-6);
  EXPECT_LT(deviation(near, pointsOf(rail60E1())), 50e-6);
  EXPECT_THROW(readProfile(path, ProfileKind::rail, {-1e-6}), std::invalid_argument);
  EXPECT_THROW(readProfile(path, ProfileKind::rail, {2.0 * max_spline_noise}), std::invalid_argument);
}

/// Converts a point to the axes of a MiniProf wheel [mm]: X from the flange back, Y towards the flange tip.
Point miniProfWheel(const Point& p)
{
  return {p.y * 1e3 + 70.0, -p.z * 1e3};
}

/// Converts a point to the axes of a MiniProf rail [mm]: X to the gauge side, Y up.
Point miniProfRail(const Point& p)
{
  return {-p.y * 1e3, p.z * 1e3};
}

TEST(MiniProfProfile, OriginOfAWheelIsOnTheRunningCircle)
{
  const Folder folder;
  const std::vector<Point> points = pointsOf(s1002Wheel());
  const std::string header =
      "ProgramName=MiniProf for Windows\nSide=L\nTilt=\nColumnDef=X,Y\nXYPoints=" + std::to_string(points.size()) +
      "\nXoffset=0.0000\nYoffset=0.0000\n";
  const Profile wheel = readProfile(folder.write("a.whl", header + "\n" + lines(changed(points, miniProfWheel), "  ")),
                                    ProfileKind::wheel, {0.0});
  EXPECT_LT(deviation(wheel, points), 1e-12);

  // Running circle 73.5 mm from the flange back, heights from another reference.
  const CurvePoint origin = s1002Wheel().at(parameterAt(s1002Wheel(), 3.5 * mm));
  const std::vector<Point> raised = moved(changed(points, miniProfWheel), 0, 2);
  const std::string path = folder.write("b.whl", header + "WheelDiameterTaperline=73.5\n" + lines(raised, "\t"));
  const Profile other = readProfile(path, ProfileKind::wheel, {0.0});
  EXPECT_LT(deviation(other, moved(points, -origin.y, -origin.z)), 1e-11);

  // The wheelset has another one: it is refused, or used if the file states none.
  ProfileReading wheelset{0.0};
  wheelset.tape_circle = 0.070;
  EXPECT_TRUE(contains(refusalOf<FileError>([&] { readProfile(path, ProfileKind::wheel, wheelset); }),
                       "WheelDiameterTaperline = 73.5 mm contradicts wheelset/tape_circle = 70 mm"));
  wheelset.tape_circle = 0.0735;
  const std::string silent = folder.write("c.whl", header + lines(raised, " "));
  EXPECT_LT(deviation(readProfile(silent, ProfileKind::wheel, wheelset), moved(points, -origin.y, -origin.z)), 1e-11);
}

TEST(MiniProfProfile, WheelThatEndsBesideItsRunningCircleIsRejected)
{
  const std::string points = lines(changed(pointsOf(s1002Wheel()), miniProfWheel), " ");
  expectTextRejected("WheelDiameterTaperline=920\n" + points, 0, "X = 920 mm", ProfileKind::wheel, "bad.whl");
  // X counted from the running circle; the tread then ends before X = 70 mm.
  expectTextRejected("Xoffset=-70\n" + points, 0, "X = 70 mm", ProfileKind::wheel, "bad.whl");
}

TEST(MiniProfProfile, GaugeSideOfARailIsAtPositiveX)
{
  const Folder folder;
  std::vector<Point> points = pointsOf(rail60E1());
  points.resize(points.size() - 100);  // the field side is not measured completely
  std::string text = "\"RefPoint1=\"\nColumnDef=N,Y,X,A\nXoffset=1.5\nYoffset=-0.25\n";
  std::ostringstream rows;
  rows << std::setprecision(12);
  for (const Point& p : changed(points, miniProfRail))
  {
    rows << "7 " << p.z + 0.25 << " " << p.y - 1.5 << " 0.1\n";
  }
  const Profile rail = readProfile(folder.write("head.BAN", text + rows.str()), ProfileKind::rail, {0.0});
  EXPECT_LT(deviation(rail, points), 1e-12);
  EXPECT_NEAR(rail.at(0.0).z, points.front().z, 1e-12);
}

TEST(MiniProfProfile, PointsWithoutNoiseAreNotSmoothed)
{
  const Folder folder;
  const std::vector<Point> points = pointsOf(rail60E1());
  const std::string rows = lines(changed(points, miniProfRail), " ");
  for (const char* header : {"", "ColumnDef=X,Y,A,C\n"})  // of four columns, the first two are there
  {
    const DescribedProfile rail = describedProfile(folder.write("head.ban", header + rows), ProfileKind::rail);
    EXPECT_LT(deviation(rail.profile, points), 1e-12);
    EXPECT_EQ(contains(rail.report.text, "2 columns instead of the 4 of ColumnDef"), header[0] != 0);
  }
}

TEST(MiniProfProfile, OldFilesWithFreeTextAreRead)
{
  const Folder folder;
  const std::vector<Point> points = pointsOf(s1002Wheel());
  const std::string header = "#MINIWHEELPROF\nwheel 12\nCar Number..:\n\" 32.58 37.11 14.71\n(Sd/Sh/qR)\n\n";
  const std::string points_text = lines(changed(points, miniProfWheel), "    ");
  const std::string path = folder.write("old.whl", header + points_text);
  expectRejected(folder.write("tilt.whl", "MINIPROF 101\nStock...: 5\nTilt=0.02\n" + points_text), ProfileKind::wheel,
                 3, "Tilt");
  EXPECT_LT(deviation(readProfile(path, ProfileKind::wheel, {0.0}), points), 1e-12);
}

TEST(MiniProfProfile, DamagedFilesAreRejected)
{
  const std::vector<Point> rail = changed(pointsOf(rail60E1()), miniProfRail);
  const std::string points = lines(rail, " ");
  const std::size_t count = rail.size();
  const auto rejected = [](const std::string& text, std::size_t line, const std::string& reason)
  { expectTextRejected(text, line, reason, ProfileKind::rail, "bad.ban"); };
  rejected("XYPoints=" + std::to_string(count + 1) + "\n" + points, count + 1, "truncated");
  rejected("ColumnDef=A,X,Y\n" + points, 2, "ColumnDef states 3");
  rejected("ColumnDef=X,Y\n" + points + "12.5 1 2\n", count + 2, "number of columns is 3");
  rejected("ColumnDef=X,A\n" + points, 1, "ColumnDef has no Y");
  rejected("Tilt=0.5\n" + points, 1, "Tilt");
  rejected("Xoffset=one\n" + points, 1, "not a plausible number");
  rejected("Dear reader,\n" + points, 1, "not a MiniProf profile");
  rejected(points + "12.5\n", count + 1, "number of columns is 1");
  rejected(points + "12.5 gauge\n", count + 1, "'gauge' is not a finite number");
  rejected("Comment=none\n", 0, "number of points is 0");
  rejected(lines(pointsOf(rail60E1()), " "), 0, "wrong unit");
  rejected(lines(scaled(rail, 1, -1), " "), 0, "z does not point up");
}
}  // namespace
}  // namespace wheel_rail_contact::core
