// What the page says by itself, before the app speaks and after it has stopped, in the app's four languages.

const WORDS = {
  en: {
    loading: "Clipscope is coming",
    loadingOf: (of, total) => `Clipscope is coming: ${of} of ${total} MB`,
    starting: "Clipscope is starting",
    "no-webgl":
      "Clipscope draws with WebGL 2, and this browser has none. Switch on hardware acceleration in its settings, or open this page in another browser.",
    broken: "Clipscope did not arrive whole.",
    brokenMore: "The connection broke off, or the server has not sent all of it. What you did before is kept.",
    again: "Try again",
    stopped: "Clipscope has stopped: it made a mistake.",
    stoppedMore: (why) => `What you did until a second before is kept. The mistake: ${why}`,
    reopen: "Open it where it was",
    newer: "There is a newer Clipscope: load it",
    old: "This browser is too old for Clipscope.",
    oldMore: (why) => `It needs WebAssembly with SIMD: Chrome 91, Firefox 89, Safari 16.4 or newer. The browser says: ${why}`,
  },
  "zh-CN": {
    loading: "正在下载 Clipscope",
    loadingOf: (of, total) => `正在下载 Clipscope：${of} / ${total} MB`,
    starting: "正在启动 Clipscope",
    "no-webgl": "Clipscope 用 WebGL 2 绘图，而这个浏览器没有。请在浏览器设置里打开硬件加速，或换一个浏览器打开本页。",
    broken: "Clipscope 没有下载完整。",
    brokenMore: "连接中断了，或者服务器没有发完。您之前的工作已经保存。",
    again: "重试",
    stopped: "Clipscope 出错，已停止运行。",
    stoppedMore: (why) => `您在一秒之前所做的都已保存。错误：${why}`,
    reopen: "从原处重新打开",
    newer: "Clipscope 有新版本：重新加载",
    old: "这个浏览器太旧，不能运行 Clipscope。",
    oldMore: (why) => `它需要带 SIMD 的 WebAssembly：Chrome 91、Firefox 89、Safari 16.4 或更新的版本。浏览器的说明：${why}`,
  },
  es: {
    loading: "Clipscope está llegando",
    loadingOf: (of, total) => `Clipscope está llegando: ${of} de ${total} MB`,
    starting: "Clipscope está arrancando",
    "no-webgl":
      "Clipscope dibuja con WebGL 2 y este navegador no lo tiene. Activa la aceleración por hardware en sus ajustes o abre esta página en otro navegador.",
    broken: "Clipscope no ha llegado entero.",
    brokenMore: "Se cortó la conexión o el servidor no lo envió todo. Lo que hiciste antes está guardado.",
    again: "Probar de nuevo",
    stopped: "Clipscope se ha detenido: cometió un error.",
    stoppedMore: (why) => `Lo que hiciste hasta un segundo antes está guardado. El error: ${why}`,
    reopen: "Abrirlo donde estaba",
    newer: "Hay un Clipscope más nuevo: cárgalo",
    old: "Este navegador es demasiado antiguo para Clipscope.",
    oldMore: (why) => `Hace falta WebAssembly con SIMD: Chrome 91, Firefox 89, Safari 16.4 o posteriores. El navegador dice: ${why}`,
  },
  "pt-BR": {
    loading: "O Clipscope está chegando",
    loadingOf: (of, total) => `O Clipscope está chegando: ${of} de ${total} MB`,
    starting: "O Clipscope está iniciando",
    "no-webgl":
      "O Clipscope desenha com WebGL 2, e este navegador não o tem. Ative a aceleração de hardware nas configurações ou abra esta página em outro navegador.",
    broken: "O Clipscope não chegou inteiro.",
    brokenMore: "A conexão caiu ou o servidor não enviou tudo. O que você fez antes está guardado.",
    again: "Tentar de novo",
    stopped: "O Clipscope parou: cometeu um erro.",
    stoppedMore: (why) => `O que você fez até um segundo antes está guardado. O erro: ${why}`,
    reopen: "Abrir onde estava",
    newer: "Há um Clipscope mais novo: carregue-o",
    old: "Este navegador é antigo demais para o Clipscope.",
    oldMore: (why) => `Ele precisa de WebAssembly com SIMD: Chrome 91, Firefox 89, Safari 16.4 ou mais novos. O navegador diz: ${why}`,
  },
};

/** The language that is wanted most of those that are known. */
export function language(wanted) {
  for (const tag of wanted) {
    const known = Object.keys(WORDS).find((lang) => lang.split("-")[0] === tag.toLowerCase().split("-")[0]);
    if (known) return known;
  }
  return "en";
}

export const LANGUAGES = WORDS;

export const words = (lang) => WORDS[lang];
