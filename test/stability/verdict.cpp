// SPDX-License-Identifier: BSD-3-Clause
#include "verdict.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
const std::string flag = "flagged";

bool startsWith(const std::string& text, const std::string& beginning)
{
  return text.rfind(beginning, 0) == 0;
}

bool isRight(const std::string& text)
{
  return startsWith(text, error_classes.front().text);
}
}  // namespace

Verdict Verdict::byLimit(double value, double limit, const Verdict& above, const Verdict& below)
{
  const bool is_below = value <= limit;
  Verdict verdict = is_below ? below : above;
  if (std::abs(value - limit) <= border_margin * limit)
  {
    const std::vector<std::string>& others = (is_below ? above : below).texts_;
    verdict.texts_.insert(verdict.texts_.end(), others.begin(), others.end());
  }
  return verdict;
}

Verdict Verdict::ofError(double error)
{
  Verdict verdict = error_classes.back().text;
  for (std::size_t k = error_classes.size() - 1; k-- > 0;)
  {
    verdict = byLimit(error, error_classes[k].upper, verdict, error_classes[k].text);
  }
  return verdict;
}

Verdict Verdict::rounded(double value, double unit)
{
  const auto multiple = [unit](double number)
  {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", std::max(0, static_cast<int>(std::ceil(-std::log10(unit)))),
                  number * unit);
    return std::string(text);
  };
  const double nearest = std::round(value / unit), other = nearest * unit < value ? nearest + 1 : nearest - 1;
  Verdict verdict = multiple(nearest).c_str();
  verdict.texts_.push_back(multiple(other));
  return verdict;
}

Verdict Verdict::refused(const std::string& reason)
{
  Verdict verdict = "refused";
  verdict.reason_ = reason;
  return verdict;
}

Verdict Verdict::with(const Verdict& other, const char* separator) const
{
  Verdict verdict = *this;
  verdict.texts_.clear();
  for (const std::string& first : texts_)
  {
    for (const std::string& second : other.texts_)
    {
      std::string text = first;
      text += first.empty() || second.empty() ? "" : separator;
      verdict.texts_.push_back(text += second);
    }
  }
  return verdict;
}

Verdict Verdict::withFlag(double estimate, double tolerance) const
{
  const Verdict flagging = byLimit(estimate, tolerance, flag.c_str(), "");
  Verdict verdict = *this;
  verdict.texts_.clear();
  for (const std::string& text : texts_)
  {
    Verdict one = text.c_str();
    one = isRight(text) ? one : one.with(flagging);
    verdict.texts_.insert(verdict.texts_.end(), one.texts_.begin(), one.texts_.end());
  }
  return verdict;
}

bool Verdict::allows(const std::string& written) const
{
  return std::find(texts_.begin(), texts_.end(), written) != texts_.end();
}

bool Verdict::isReliable() const
{
  return isRight(text()) || startsWith(text(), "refused") || startsWith(text(), "no contact") ||
         text().find(flag) != std::string::npos;
}
}  // namespace wheel_rail_contact::core::stability
