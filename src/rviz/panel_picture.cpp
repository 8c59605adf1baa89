// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel_picture.h"

#include <QFont>
#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

#include "ros/markers/color_map.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int ticks = 5;            ///< number of labels of the colour scale
constexpr int bar_in_letters = 24;  ///< length of the colour scale / height of the letters [-]
const QColor background(20, 23, 27, 200);
const QColor foreground(235, 235, 235);

QFont panelFont(int letter_size)
{
  QFont font("DejaVu Sans Mono");
  font.setStyleHint(QFont::Monospace);
  font.setPixelSize(letter_size);
  return font;
}

QColor pressureColor(double share)
{
  const std_msgs::ColorRGBA color = colorOf(share);
  return QColor::fromRgbF(color.r, color.g, color.b);
}

QString tickText(int tick, double max_pressure)
{
  const QString number = QString::number(max_pressure * tick / (ticks - 1) / 1e6, 'f', 0);
  return tick + 1 == ticks ? number + " MPa" : number;
}

/// Colour scale with its upper left corner at (x, y), and its labels below it.
void paintBar(QPainter& painter, int x, int y, int length, int height, double max_pressure)
{
  for (int i = 0; i < length; ++i)
  {
    painter.fillRect(x + i, y, 1, height, pressureColor((i + 0.5) / length));
  }
  const QFontMetrics metrics = painter.fontMetrics();
  for (int tick = 0; tick < ticks; ++tick)
  {
    const int place = x + length * tick / (ticks - 1);
    painter.fillRect(place, y, 1, height + height / 3, foreground);
    painter.drawText(tick == 0 ? place : place - metrics.averageCharWidth(), y + height + metrics.height(),
                     tickText(tick, max_pressure));
  }
}

int widthOf(const std::vector<std::string>& lines, const QFontMetrics& metrics)
{
  int width = 0;
  for (const std::string& line : lines)
  {
    width = std::max(width, metrics.horizontalAdvance(QString::fromStdString(line)));
  }
  return width;
}
}  // namespace

QImage panelPicture(const std::vector<std::string>& lines, double max_pressure, int letter_size)
{
  const QFont font = panelFont(letter_size);
  const QFontMetrics metrics(font);
  const int margin = letter_size, bar_length = bar_in_letters * letter_size;
  const int bar_width = bar_length + metrics.horizontalAdvance(tickText(ticks - 1, max_pressure));
  const int text_height = static_cast<int>(lines.size()) * metrics.lineSpacing();
  QImage image(2 * margin + std::max(widthOf(lines, metrics), bar_width),
               text_height + 3 * margin + metrics.height() + letter_size, QImage::Format_ARGB32);
  image.fill(background);
  QPainter painter(&image);
  painter.setFont(font);
  painter.setPen(foreground);
  int y = margin + metrics.ascent();
  for (const std::string& line : lines)
  {
    painter.drawText(margin, y, QString::fromStdString(line));
    y += metrics.lineSpacing();
  }
  paintBar(painter, margin, margin + text_height + letter_size / 2, bar_length, letter_size, max_pressure);
  return image;
}
}  // namespace wheel_rail_contact
