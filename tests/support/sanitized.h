// Whether the program was compiled with sanitizers. It then takes some ten times as long, and tests
// of many random scenes take fewer.
#pragma once

namespace terrview {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

// How many of so many random scenes a test takes.
constexpr int fewer_if_sanitized(int scenes) { return kSanitized ? scenes / 3 : scenes; }

}  // namespace terrview
