// SPDX-License-Identifier: BSD-3-Clause
// Tables with points of profiles, as spreadsheets and programs write them.
#include "profile_helpers.h"

namespace wheel_rail_contact::core
{
namespace
{
constexpr double digits = 2e-9;  ///< rounding of the points of these tests: 1e-6 mm [m]

/// A row for each point of 60E1 in millimetres, by a format of two numbers.
std::string rows(const char* format, double unit = mm)
{
  std::string text;
  for (const Point& p : pointsOf(rail60E1()))
  {
    char row[100];
    std::snprintf(row, sizeof row, format, p.y / unit, p.z / unit);
    text += row;
  }
  return text;
}

std::string replaced(std::string text, const std::string& old, const std::string& by)
{
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size()))
  {
    text.replace(at, old.size(), by);
  }
  return text;
}

std::string asUtf16(const std::string& text, bool big_endian)
{
  std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text)
  {
    bytes += big_endian ? std::string({'\0', c}) : std::string({c, '\0'});
  }
  return bytes;
}

class TableTest : public testing::Test
{
 protected:
  /// Expects the file to be the head of 60E1.
  void expectRail(const std::string& what, const std::string& text, const ProfileReading& reading = {}) const
  {
    SCOPED_TRACE(what);
    const Profile read = readProfile(folder_.write("rail.txt", text), ProfileKind::rail, reading);
    EXPECT_LT(deviation(read, pointsOf(rail60E1())), digits);
  }

  /// Message of the refusal.
  std::string refusal(const std::string& text, const ProfileReading& reading = {},
                      ProfileKind kind = ProfileKind::rail) const
  {
    return thrownBy<FileError>([&] { readProfile(folder_.write("bad.txt", text), kind, reading); }).reason();
  }

  const std::string comma_ = rows("%.6f,%.6f\n");
  Folder folder_;
};
}  // namespace

TEST_F(TableTest, SeparatorsAndDecimalSigns)
{
  const std::string titles = "y_mm,z_mm\n";
  expectRail("comma", titles + comma_);
  expectRail("comma and blank", titles + rows("%.6f, %.6f\n"));
  expectRail("commas between blanks", titles + rows("  %.6f ,  %.6f  \n"));
  expectRail("semicolon", "y_mm;z_mm\n" + rows("%.6f;%.6f\n"));
  expectRail("semicolon and decimal comma", "y_mm;z_mm\n" + replaced(rows("%.6f;%.6f\n"), ".", ","));
  expectRail("tab", "y_mm\tz_mm\n" + rows("%.6f\t%.6f\n"));
  expectRail("tab and decimal comma", "y_mm\tz_mm\n" + replaced(rows("%.6f\t%.6f\n"), ".", ","));
  expectRail("blanks", "y_mm z_mm\n" + rows("   %.6f   %.6f\n"));
  expectRail("blanks and decimal comma", "y_mm z_mm\n" + replaced(rows("%.6f  %.6f\n"), ".", ","));
  expectRail("separator at the end", titles + rows("%.6f,%.6f,\n"));
  expectRail("signs and exponents", titles + rows("%+.9E,%+.9E\n"));
  expectRail("Fortran exponents", titles + replaced(rows("%.9E,%.9E\n"), "E", "D"));
  EXPECT_TRUE(contains(refusal(titles + replaced(comma_, ".", ",")), "with decimal commas"));
}

TEST_F(TableTest, LineEndsAndEncodings)
{
  const std::string text = "y_mm,z_mm\n" + comma_;
  expectRail("CRLF", replaced(text, "\n", "\r\n"));
  expectRail("CR", replaced(text, "\n", "\r"));
  expectRail("UTF-8 with mark", "\xEF\xBB\xBF" + text);
  expectRail("UTF-16, little endian", asUtf16(text, false));
  expectRail("UTF-16, big endian", asUtf16(replaced(text, "\n", "\r\n"), true));
  expectRail("Latin-1", "# gemessen in K\xF6ln\n" + text);
  expectRail("end of file of DOS", text + "\x1A");
  EXPECT_TRUE(contains(refusal(text + std::string("\0", 1)), "binary"));
}

TEST_F(TableTest, Comments)
{
  for (const char* sign : {"#", "%", "!", "//"})
  {
    const std::string comment = sign + std::string(" worn, left\n");
    expectRail(sign, comment + "y_mm,z_mm\n" + comment + comma_ + comment);
    expectRail("titles after " + std::string(sign), sign + std::string(" y_mm,z_mm\n") + comma_);
    expectRail("row with " + std::string(sign), "y_mm,z_mm\n" + replaced(comma_, "\n", " " + comment));
  }
  EXPECT_TRUE(contains(refusal("y_mm,z_mm\n" + comma_ + "end\n"), "number of columns is 1"));
  EXPECT_TRUE(contains(refusal("measured on Monday\ny_mm,z_mm\n" + comma_), "is neither a comment nor"));
}

TEST_F(TableTest, SpellingsOfTitles)
{
  for (const char* titles :
       {"y_mm,z_mm", "Y_MM,Z_MM", "y [mm],z [mm]", "Y (mm), Z (mm)", "y/mm,z/mm", "\"y [mm]\",\"z [mm]\"", "y,z\nmm,mm",
        "y,z\n[mm],[mm]", "sep=,\ny_mm,z_mm", "509\ny_mm,z_mm", "x_mm,y_mm", "X [mm],Z [mm]",
        "lateral [mm],vertical [mm]", "# y_mm,z_mm (worn head)"})
  {
    expectRail(titles, titles + std::string("\n") + comma_);
  }
  expectRail("slashes between blanks", "Y / mm  Z / mm\n" + rows("%.6f  %.6f\n"));
  expectRail("units in brackets between blanks", "y z\n[mm] [mm]\n" + rows("%.6f  %.6f\n"));
  EXPECT_TRUE(contains(refusal("y_mm,z_mm\nm,m\n" + comma_), "contradicts"));
  EXPECT_TRUE(contains(refusal("y_mm,z_mm,y_mm,z_mm\n" + replaced(comma_, "\n", ",0,0\n")), "given twice"));
  expectRail("titles with blanks", "y [mm]   z [mm]\n" + rows("%.6f  %.6f\n"));
  expectRail("metre", "y [m];z [m]\n" + rows("%.9f;%.9f\n", 1));
  expectRail("inch", "y_in,z_in\n" + rows("%.8f,%.8f\n", 0.0254));
  expectRail("centimetre", "y [cm],z [cm]\n" + rows("%.7f,%.7f\n", 0.01));
  expectRail("micrometre", "y [\xB5m],z [\xB5m]\n" + rows("%.3f,%.3f\n", 1e-6));
}

TEST_F(TableTest, ColumnsAreFoundByTheirTitles)
{
  const std::string three = replaced(comma_, "\n", ",0.5\n");
  const std::string path = folder_.write("three.csv", "y_mm,z_mm,curvature\n" + three);
  const DescribedProfile read = describedProfile(path, ProfileKind::rail);
  EXPECT_LT(deviation(read.profile, pointsOf(rail60E1())), digits);
  EXPECT_TRUE(contains(read.report.text, "ignored column curvature")) << read.report.text;
  const std::string with_x = replaced("\n" + comma_, "\n", "\n7,").substr(1);
  expectRail("x along the track", "x_m,y_mm,z_mm\n" + with_x.substr(0, with_x.size() - 2));
  EXPECT_TRUE(contains(refusal(three), "3 columns without titles"));
}

// The file does not state them. The message lists the values by which the points are a profile.
TEST_F(TableTest, UnitAndAxesAreAskedFor)
{
  EXPECT_EQ(refusal(comma_),
            "the file does not state its unit, y, z, and no option does. The points are a profile by unit: mm, y: "
            "inward or outward, z: up");
  ProfileReading reading;
  reading.unit = mm;
  reading.y = ProfileReading::Y::outward;
  EXPECT_TRUE(contains(refusal(comma_, reading), "does not state its z, "));
  reading.z = ProfileReading::Z::up;
  expectRail("with options", comma_, reading);

  const std::string wheel = lines(scaled(pointsOf(s1002Wheel()), -1, -1), " ");
  EXPECT_TRUE(contains(refusal(wheel, {}, ProfileKind::wheel), "unit: m, y: inward, z: down"));
  EXPECT_TRUE(contains(refusal("y,z\n" + comma_), "does not state its unit, "));
  EXPECT_TRUE(contains(refusal("0,0\n1,1\n2,2\n3,3\n"), "no profile by any values"));
}

TEST_F(TableTest, OptionsMustNotContradictTheFile)
{
  ProfileReading reading;
  reading.unit = 1;
  EXPECT_TRUE(contains(refusal("y_mm,z_mm\n" + comma_, reading), "unit m contradicts mm in the file"));
  reading.unit = mm;
  expectRail("the same unit", "y_mm,z_mm\n" + comma_, reading);
}

TEST_F(TableTest, StatedDirectionsReplaceThoseOfTheFormat)
{
  ProfileReading reading;
  reading.z = ProfileReading::Z::down;
  const std::string down = "y_mm,z_mm\n" + replaced(replaced(comma_, ",", ",-"), "--", "");
  EXPECT_TRUE(contains(refusal(down), "the points are a profile by y: inward or outward, z: down")) << refusal(down);
  expectRail("z down", down, reading);
}

TEST_F(TableTest, ShuffledPointsAreRefused)
{
  std::string text = comma_;
  const std::size_t first = text.find('\n', 3000) + 1, second = text.find('\n', first) + 1;
  text = text.substr(second) + text.substr(0, second);
  EXPECT_TRUE(contains(refusal("y_mm,z_mm\n" + text), "points run back"));
}

TEST_F(TableTest, OverlapOfTwoStrokesIsOmitted)
{
  const std::vector<Point> rail = scaled(pointsOf(rail60E1()), 1e3, 1e3);
  std::vector<Point> points(rail.begin(), rail.begin() + 250);
  points.insert(points.end(), rail.begin() + 247, rail.end());
  expectRail("0.75 mm", "y_mm,z_mm\n" + lines(points, ","));
}
}  // namespace wheel_rail_contact::core
