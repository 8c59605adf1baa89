// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreMaterial.h>
#include <OgreTexture.h>
#include <Overlay/OgreOverlay.h>
#include <Overlay/OgreOverlayContainer.h>
#include <std_msgs/ColorRGBA.h>
#include <QImage>
#include <QPoint>

#include <string>
#include <vector>

#include "ros/evaluation/result_text.h"

namespace wheel_rail_contact
{
/// Meaning of a colour of the scene.
struct LegendEntry
{
  std_msgs::ColorRGBA color;  ///< colour of the field before the text
  std::string text;           ///< UTF-8
};

/// Colour scale of a pressure or a stress.
struct PanelScale
{
  std::string caption;  ///< above the scale
  double max = 1e9;     ///< upper end [Pa], > 0
  double highest = 0;   ///< if it is above the scale, the scale has a note [Pa]
};

/// Contents of the screen panel.
struct PanelContents
{
  std::vector<TextLine> lines;      ///< text; the first line is drawn larger
  std::vector<PanelScale> scales;   ///< below the text, one beside another
  std::vector<LegendEntry> legend;  ///< below the colour scales
};

/// Lines of text above colour scales in MPa and a legend, on a dark translucent background.
/// @param letter_size height of the letters [pixels]
QImage panelPicture(const PanelContents& contents, int letter_size);

/// A picture in the upper left corner of the render window of rviz, in front of the scene.
class ScreenPanel
{
 public:
  ScreenPanel();
  ~ScreenPanel();
  ScreenPanel(const ScreenPanel&) = delete;
  ScreenPanel& operator=(const ScreenPanel&) = delete;

  /// Shows a picture.
  /// @param image in the format QImage::Format_ARGB32
  /// @param corner upper left one on the screen [pixels]
  void show(const QImage& image, const QPoint& corner);
  /// Hides the picture.
  void hide();

 private:
  void resize(int width, int height);

  std::string name_;  ///< unique name of material, texture, panel and overlay in Ogre
  Ogre::MaterialPtr material_;
  Ogre::TexturePtr texture_;
  Ogre::OverlayContainer* panel_;
  Ogre::Overlay* overlay_;
};
}  // namespace wheel_rail_contact
