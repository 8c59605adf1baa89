// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/screen_panel.h"

#include <OgreHardwarePixelBuffer.h>
#include <OgreMaterialManager.h>
#include <OgreTechnique.h>
#include <OgreTextureManager.h>
#include <Overlay/OgreOverlayManager.h>

namespace wheel_rail_contact
{
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

void ScreenPanel::show(const QImage& image)
{
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
