//! Text as Markdown spells it.

/// Text in which nothing is markup. What is none is left alone, so that the page can be read as it is.
pub fn as_markdown(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut before = ' ';
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        let after = chars.peek().copied().unwrap_or(' ');
        let is_markup = match c {
            '\\' | '|' | '`' | '*' | '[' | ']' | '~' | '$' => true,
            '_' => !(before.is_alphanumeric() && after.is_alphanumeric()),
            '<' => !after.is_whitespace(),
            '&' => after.is_alphanumeric() || after == '#',
            _ => false,
        };
        if is_markup {
            out.push('\\');
        }
        out.push(c);
        before = c;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_given_is_taken_for_markup() {
        assert_eq!(
            as_markdown("a|b *c* <d> &lt; `e`"),
            r"a\|b \*c\* \<d> \&lt; \`e\`"
        );
        assert_eq!(as_markdown("u_min < u_max & _x_"), r"u_min < u_max & \_x\_");
    }
}
