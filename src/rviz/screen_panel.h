// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreMaterial.h>
#include <OgreTexture.h>
#include <Overlay/OgreOverlay.h>
#include <Overlay/OgreOverlayContainer.h>

#include <QImage>
#include <string>

namespace wheel_rail_contact
{
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
  void show(const QImage& image);
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
