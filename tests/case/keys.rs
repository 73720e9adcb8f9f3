//! Answer keys and worksheets: what is handed out.

use clipscope::{case::Format, text::Lang};

use super::{
    asked::{answers, line, style},
    range::all_cases,
};

const BLANK: &str = "…………";

/// Of the table of steps each row's cells, in Markdown.
fn steps(page: &str) -> Vec<Vec<String>> {
    let rows = page.lines().skip_while(|line| !line.starts_with("| 0 |"));
    let rows = rows.take_while(|line| !line.is_empty());
    let cells = |row: &str| {
        let row = row.trim_start_matches("| ").trim_end_matches(" |");
        row.split(" | ").map(|it| it.trim().to_owned()).collect()
    };
    rows.map(cells).collect()
}

fn head(page: &str) -> Vec<&str> {
    page.lines()
        .filter(|line| line.starts_with("- **"))
        .collect()
}

#[test]
fn a_worksheet_asks_for_all_that_its_key_answers_and_answers_nothing() {
    for (algorithm, fields) in all_cases() {
        let case = line(algorithm, fields);
        for lang in Lang::ALL {
            let key = answers(&case, style(Format::Markdown, lang));
            let sheet = answers(&case, style(Format::Worksheet, lang));
            assert!(!sheet.contains('⟦'), "{sheet}");
            assert_eq!(head(&key), head(&sheet), "what is given");
            let (key, asked) = (steps(&key), steps(&sheet));
            assert_eq!((key.len(), &key[0]), (asked.len(), &asked[0]), "{case}");
            for (key, asked) in key.iter().zip(&asked).skip(1) {
                let [step, what, formulas, changed] = &asked[..] else {
                    panic!("{lang}, {case}: four columns, not {asked:?}");
                };
                assert_eq!(*step, key[0]);
                let options = what.split("<br>").filter(|it| it.starts_with("☐ "));
                let n_options = options.count();
                assert!(n_options > 1 || what == BLANK, "{case}: {what}");
                let has_digit = |text: &str| text.contains(|c: char| c.is_ascii_digit());
                assert!(!has_digit(formulas), "{case}: {formulas}");
                for (key, asked) in [(&key[2], formulas), (&key[3], changed)] {
                    let n_told = match n_options {
                        _ if key.is_empty() => 0,
                        0 => key.split("<br>").count(),
                        // Their names would tell which of the options is right.
                        _ => 1,
                    };
                    let blanks = asked.split("<br>").filter(|it| it.ends_with(BLANK));
                    assert_eq!(blanks.count(), n_told, "{case}: {asked}");
                    assert!(n_options == 0 || [BLANK, ""].contains(&&**asked), "{asked}");
                }
                let values = changed.split(" = ").skip(1);
                let mut values = values.filter(|value| !value.starts_with(BLANK));
                assert_eq!(values.next(), None, "{case}: {changed}");
            }
            let blanks = sheet
                .lines()
                .filter(|line| line.ends_with(&format!(" {BLANK} |")));
            assert!(blanks.count() >= 5, "what it costs: {sheet}");
            assert!(
                sheet
                    .lines()
                    .any(|line| line.ends_with(&format!("** {BLANK}")))
            );
        }
    }
}

#[test]
fn numbers_of_a_key_are_all_fractions_or_all_decimals() {
    for (algorithm, fields) in all_cases() {
        let key = answers(&line(algorithm, fields), style(Format::Markdown, Lang::En));
        let lines = key.lines().filter(|line| !line.starts_with("- **Source"));
        let text: Vec<char> = lines.flat_map(str::chars).collect();
        let parts_digits = |part: char| {
            let is_digit = |c: char| c.is_ascii_digit();
            let parts = |it: &&[char]| is_digit(it[0]) && it[1] == part && is_digit(it[2]);
            let found = text.windows(3).find(parts);
            found.map(|it| it.iter().collect::<String>())
        };
        let (fraction, decimal) = (parts_digits('/'), parts_digits('.'));
        assert!(
            fraction.is_none() || decimal.is_none(),
            "{fraction:?}, {decimal:?}: {key}"
        );
    }
}

#[test]
fn an_entry_of_a_list_is_new_once_and_its_vertices_have_one_name() {
    let fields = r#""clip":[[0,0],[4,0],[4,3],[0,3]],"polygon":[[-1,1],[1,1],[1,2],[2,2],[2,1],
        [3,1],[3,2],[5,2],[5,4],[-1,4]],"holes":[[[0.5,2.5],[0.5,3.5],[1,3.5]]]"#;
    let case = line("weiler-atherton", &fields.replace('\n', ""));
    let key = answers(&case, style(Format::Markdown, Lang::En));
    assert!(
        head(&key).iter().any(|line| line.contains("S₁ = (−1, 1)")),
        "{key}"
    );
    assert!(!key.contains("V₁"), "{key}");
    assert!(key.contains("a₁, a₂: the distances"), "{key}");
    let steps = steps(&key);
    let changed = steps.iter().flat_map(|cells| cells[3].split("<br>"));
    let in_lists = changed.filter(|it| it.contains(": S = ") || it.contains(": C = "));
    let mut told: Vec<&str> = in_lists.collect();
    let n_told = told.len();
    assert!(n_told > 20, "{key}");
    told.sort_unstable();
    told.dedup();
    assert_eq!(told.len(), n_told, "what only moved is not new: {key}");
}

#[test]
fn what_is_refused_stands_on_no_page_and_leaves_the_title_to_the_next() {
    let refused = r#"{"algorithm":"liang-barsky"}"#;
    let good = line(
        "liang-barsky",
        r#""window":[-1,-1,1,1],"segment":[-2,0,2,0]"#,
    );
    let cases = format!("{refused}\n{good}\n");
    for (format, title) in [
        (Format::Markdown, "# Answer key\n\n## Case 2 · "),
        (Format::Worksheet, "# Worksheet\n\nFill in"),
    ] {
        let page = answers(&cases, style(format, Lang::En));
        assert!(page.starts_with(title), "{page}");
        assert_eq!(page.matches("## Case").count(), 1, "{page}");
    }
}
