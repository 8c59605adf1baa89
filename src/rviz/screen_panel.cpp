// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/screen_panel.h"

#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterialManager.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <Overlay/OgreOverlayManager.h>
#include <QFont>
#include <QFontMetrics>
#include <QPainter>

#include "ros/markers/marker_tools.h"

namespace wheel_rail_contact
{
namespace
{
constexpr int ticks = 5;              ///< number of labels of the colour scale
constexpr int bar_in_letters = 24;    ///< length of the colour scale / height of the letters [-]
constexpr double banner_size = 1.35;  ///< height of the first line / height of the other letters [-]
const QColor background(20, 23, 27, 215);

QFont panelFont(double letter_size)
{
  QFont font("DejaVu Sans Mono");
  font.setStyleHint(QFont::Monospace);
  font.setPixelSize(static_cast<int>(letter_size));
  return font;
}

QColor toColor(const std_msgs::ColorRGBA& color)
{
  return QColor::fromRgbF(color.r, color.g, color.b);
}

QColor colorOfTone(Tone tone)
{
  return toColor(tone == Tone::error     ? scene_colors::error
                 : tone == Tone::warning ? scene_colors::warning
                                         : scene_colors::text);
}

/// Paints the parts of the panel one below another. Without a painter it only measures them.
class PanelWriter
{
 public:
  PanelWriter(int letter_size, QPainter* painter) : size_(letter_size), painter_(painter), y_(letter_size) {}

  void text(const std::string& line, const QColor& color, double relative_size = 1)
  {
    write(QString::fromStdString(line), size_, color, relative_size);
  }

  /// Entries one beside another.
  void legend(const std::vector<LegendEntry>& entries)
  {
    const int top = y_;
    int x = size_;
    for (const LegendEntry& entry : entries)
    {
      y_ = top;
      const QString text = QString::fromStdString(entry.text);
      field(x, y_ + size_ / 3, 2 * size_, size_ / 2, toColor(entry.color));
      write(text, x + 3 * size_, colorOfTone(Tone::normal), 1);
      x += 5 * size_ + width(text);
    }
  }

  /// Colour scales one beside another.
  void scales(const std::vector<PanelScale>& scales)
  {
    const int top = y_;
    int x = size_;
    for (const PanelScale& scale : scales)
    {
      y_ = top;
      x = std::max(scaleAt(x, scale), x + width(QString::fromStdString(scale.caption))) + 3 * size_;
    }
  }

  void space() { y_ += size_ / 2; }

  QSize size() const { return {widest_ + size_, y_ + size_ / 2}; }

 private:
  int width(const QString& text) const { return QFontMetrics(panelFont(size_)).horizontalAdvance(text); }

  void field(int x, int y, int width, int height, const QColor& color)
  {
    if (painter_)
    {
      painter_->fillRect(x, y, width, height, color);
    }
    widest_ = std::max(widest_, x + width);
  }

  /// Colour scale with its caption above and its labels below it.
  /// @return right end [pixels]
  int scaleAt(int x, const PanelScale& scale)
  {
    write(QString::fromStdString(scale.caption), x, colorOfTone(Tone::normal), 1);
    const int length = bar_in_letters * size_;
    for (int i = 0; i < length; ++i)
    {
      field(x + i, y_, 1, size_, toColor(colorOf((i + 0.5) / length)));
    }
    const int end = scale.highest > scale.max ? noteAbove(x + length, scale.highest) : x + length;
    const int top = y_;
    for (int tick = 0; tick < ticks; ++tick)
    {
      const int place = x + length * tick / (ticks - 1);
      field(place, top, 1, size_ + size_ / 3, colorOfTone(Tone::normal));
      y_ = top + size_ + size_ / 3;
      const QString number = QString::number(scale.max * tick / (ticks - 1) / 1e6, 'f', 0);
      write(number, tick == 0 ? place : place - width(number) / 2, colorOfTone(Tone::normal), 1);
    }
    return end;
  }

  /// Note beside a colour scale.
  /// @return right end [pixels]
  int noteAbove(int x, double highest)
  {
    const QString text = QString("above scale: %1 MPa").arg(highest / 1e6, 0, 'f', 0);
    const int top = y_;
    field(x, top, 2 * size_, size_, toColor(scene_colors::above_scale));
    y_ -= size_ / 6;
    write(text, x + 3 * size_, toColor(scene_colors::above_scale), 1);
    y_ = top;
    return x + 3 * size_ + width(text);
  }

  void write(const QString& text, int x, const QColor& color, double relative_size)
  {
    const QFont font = panelFont(relative_size * size_);
    const QFontMetrics metrics(font);
    if (painter_)
    {
      painter_->setFont(font);
      painter_->setPen(color);
      painter_->drawText(x, y_ + metrics.ascent(), text);
    }
    widest_ = std::max(widest_, x + metrics.horizontalAdvance(text));
    y_ += metrics.lineSpacing();
  }

  int size_;
  QPainter* painter_;
  int y_, widest_ = 0;
};

/// Paints all parts, or measures them without a painter.
QSize paint(const PanelContents& contents, int letter_size, QPainter* painter)
{
  PanelWriter writer(letter_size, painter);
  for (const TextLine& line : contents.lines)
  {
    writer.text(line.text, colorOfTone(line.tone), &line == contents.lines.data() ? banner_size : 1);
  }
  writer.space();
  writer.scales(contents.scales);
  writer.legend(contents.legend);
  return writer.size();
}
}  // namespace

QImage panelPicture(const PanelContents& contents, int letter_size)
{
  QImage image(paint(contents, letter_size, nullptr), QImage::Format_ARGB32);
  image.fill(background);
  QPainter painter(&image);
  paint(contents, letter_size, &painter);
  return image;
}

namespace
{
const Ogre::String& group()
{
  return Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME;
}

/// A unique name for each panel.
std::string newName()
{
  static int count = 0;
  return "wheel_rail_contact/screen_panel_" + std::to_string(count++);
}
}  // namespace

ScreenPanel::ScreenPanel() : name_(newName()), material_(Ogre::MaterialManager::getSingleton().create(name_, group()))
{
  Ogre::Pass* pass = material_->getTechnique(0)->getPass(0);
  pass->setLightingEnabled(false);
  pass->setDepthCheckEnabled(false);
  pass->setDepthWriteEnabled(false);
  pass->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  pass->createTextureUnitState();

  Ogre::OverlayManager& overlays = Ogre::OverlayManager::getSingleton();
  panel_ = static_cast<Ogre::OverlayContainer*>(overlays.createOverlayElement("Panel", name_));
  panel_->setMetricsMode(Ogre::GMM_PIXELS);
  panel_->setMaterialName(name_);
  overlay_ = overlays.create(name_);
  overlay_->add2D(panel_);
}

ScreenPanel::~ScreenPanel()
{
  Ogre::OverlayManager& overlays = Ogre::OverlayManager::getSingleton();
  overlays.destroy(overlay_);
  overlays.destroyOverlayElement(panel_);
  Ogre::MaterialManager::getSingleton().remove(material_->getHandle());
  if (texture_.get() != nullptr)
  {
    Ogre::TextureManager::getSingleton().remove(texture_->getHandle());
  }
}

void ScreenPanel::resize(int width, int height)
{
  if (texture_.get() != nullptr)
  {
    Ogre::TextureManager::getSingleton().remove(texture_->getHandle());
  }
  texture_ = Ogre::TextureManager::getSingleton().createManual(
      name_, group(), Ogre::TEX_TYPE_2D, static_cast<Ogre::uint>(width), static_cast<Ogre::uint>(height), 0,
      Ogre::PF_A8R8G8B8, Ogre::TU_DEFAULT);
  material_->getTechnique(0)->getPass(0)->getTextureUnitState(0)->setTextureName(name_);
  panel_->setDimensions(static_cast<Ogre::Real>(width), static_cast<Ogre::Real>(height));
}

void ScreenPanel::show(const QImage& image, const QPoint& corner)
{
  panel_->setPosition(static_cast<Ogre::Real>(corner.x()), static_cast<Ogre::Real>(corner.y()));
  const auto width = static_cast<Ogre::uint32>(image.width()), height = static_cast<Ogre::uint32>(image.height());
  if (texture_.get() == nullptr || texture_->getWidth() != width || texture_->getHeight() != height)
  {
    resize(image.width(), image.height());
  }
  QImage copy = image;  // Ogre requires writable memory
  texture_->getBuffer()->blitFromMemory(Ogre::PixelBox(width, height, 1, Ogre::PF_A8R8G8B8, copy.bits()));
  overlay_->show();
}

void ScreenPanel::hide()
{
  overlay_->hide();
}
}  // namespace wheel_rail_contact
