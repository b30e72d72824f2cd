#include "widgets/scene/values/body_light.hpp"

#include <gtest/gtest.h>

namespace abrazo::widgets::body_light_test {
namespace {

const Vec3 into_the_picture(0, 0, -1);

TEST(BodyLight, LeavesTheShadeItsFortyTwoHundredths) {
  const BodyLight light(into_the_picture);
  EXPECT_FLOAT_EQ(light.on({0, 0, -1}), 0.42F);
}

TEST(BodyLight, FacingTheMainLampAddsItsMatteAndItsMirroredShare) {
  const BodyLight light(into_the_picture);
  const Eigen::Vector3f lamp = Eigen::Vector3f(-0.7F, 0.9F, 1.0F).normalized();
  const Eigen::Vector3f other = Eigen::Vector3f(0.9F, 0.1F, 0.8F).normalized();
  const float facing = lamp.dot(other);
  const float glint = std::pow(lamp.z(), 18.0F),
              other_glint = std::pow(2 * facing * lamp.z() - other.z(), 18.0F);
  EXPECT_NEAR(light.on(lamp),
              0.42F + 0.85F * (0.62F + 0.12F * glint) + 0.28F * (0.62F * facing + 0.12F * other_glint),
              1e-5F);
}

TEST(BodyLight, GoesWithTheCamera) {
  const BodyLight ahead(into_the_picture), aside(Vec3(-1, 0, 0));  // a quarter turn about the vertical
  for (const Eigen::Vector3f& normal :
       {Eigen::Vector3f(0, 0, 1), Eigen::Vector3f(0.6F, 0, 0.8F), Eigen::Vector3f(0, 1, 0)})
    EXPECT_NEAR(aside.on({normal.z(), normal.y(), -normal.x()}), ahead.on(normal), 1e-5F);
}

TEST(BodyLight, StaysFiniteLookingStraightDown) {
  EXPECT_TRUE(std::isfinite(BodyLight(Vec3(0, -1, 0)).on({0, 1, 0})));
}

}  // namespace
}  // namespace abrazo::widgets::body_light_test
