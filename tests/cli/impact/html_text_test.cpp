// One test per promise of cli/impact/html_text.h.
#include "cli/impact/html_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

namespace terrview {
namespace {

TEST(HtmlText, HasNoMarkup) {
  EXPECT_EQ(html_text("<script>alert(\"1\" & '2')</script>"),
            "&lt;script&gt;alert(&quot;1&quot; &amp; &#39;2&#39;)&lt;/script&gt;");
  EXPECT_EQ(html_text("Zürich – 東京"), "Zürich – 東京");
}

TEST(HtmlText, ReplacesWhatIsNoText) {
  const std::string unknown = "\xef\xbf\xbd";
  EXPECT_EQ(html_text("a\xff"
                      "b"),
            "a" + unknown + "b");
  EXPECT_EQ(html_text(std::string("a\0b\x1f", 4)), "a" + unknown + "b" + unknown);
  EXPECT_EQ(html_text("\xe6\x9d"), unknown) << "a broken letter";
  EXPECT_EQ(html_text("a\uFFFE\uFFFFb\uFFFC\x7f\n\t"),
            "a" + unknown + unknown + "b\uFFFC" + unknown + "\n\t");
}

RC_GTEST_PROP(HtmlText, IsUtf8WithoutMarkupWhateverTheBytes, (const std::string& bytes)) {
  const std::string text = html_text(bytes);
  RC_ASSERT(utf8_text(text) == text);
  RC_ASSERT(text.find_first_of("<>\"'") == std::string::npos);
}

// RFC 4648, section 10.
TEST(DataUri, IsBase64) {
  EXPECT_EQ(data_uri("image/png", ""), "data:image/png;base64,");
  EXPECT_EQ(data_uri("text/plain", "f"), "data:text/plain;base64,Zg==");
  EXPECT_EQ(data_uri("text/plain", "fo"), "data:text/plain;base64,Zm8=");
  EXPECT_EQ(data_uri("text/plain", "foo"), "data:text/plain;base64,Zm9v");
  EXPECT_EQ(data_uri("text/plain", "foobar"), "data:text/plain;base64,Zm9vYmFy");
  EXPECT_EQ(data_uri("text/plain", "\xff\xfe\xfd"), "data:text/plain;base64,//79");
}

}  // namespace
}  // namespace terrview
