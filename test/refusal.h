// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "usual_headers.h"

/// Refusals of calls.
namespace wheel_rail_contact
{
/// The exception of a call. A call that throws none, or one of another type, ends the test.
template <typename Exception, typename Call>
Exception thrownBy(const Call& call)
{
  try
  {
    call();
  }
  catch (const Exception& error)
  {
    return error;
  }
  throw std::runtime_error("the call was accepted");
}

/// Message with which a call is refused; "accepted" if it is not.
template <typename Exception = std::invalid_argument, typename Call>
std::string refusalOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const Exception& error)
  {
    return error.what();
  }
  return "accepted";
}

inline testing::AssertionResult contains(const std::string& text, const std::string& part)
{
  const bool found = text.find(part) != std::string::npos;
  return (found ? testing::AssertionSuccess() : testing::AssertionFailure()) << '"' << part << "\" and: " << text;
}

namespace core
{
using wheel_rail_contact::contains, wheel_rail_contact::refusalOf, wheel_rail_contact::thrownBy;
}  // namespace core
}  // namespace wheel_rail_contact
